// SPDX-License-Identifier: GPL-3.0-or-later
// What a text says about the face that a receiver lies on: its number, an
// object or a group, or "auto".

#ifndef TRUELUX_TEXT_FACE_CHOICE_H_
#define TRUELUX_TEXT_FACE_CHOICE_H_

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux {

/// A face that has to be found, as Scene::FaceNear does.
struct FaceSearch {
  std::string name;             ///< of an object or a group; "": any face
  std::optional<double> limit;  ///< of any face, if one was given
};

/// How a receiver's face is chosen.
struct FaceChoice {
  int number = 0;                      ///< the face's, from 1; 0: none
  const FaceSearch* search = nullptr;  ///< instead of the number
};

/// Reads choices, for one scene. Keeps the searches that choices point to.
class FaceWords {
 public:
  /// scene: must outlive the object.
  explicit FaceWords(const Scene& scene) : scene_(scene) {}

  /// Not copied: choices point into it.
  FaceWords(const FaceWords&) = delete;
  FaceWords& operator=(const FaceWords&) = delete;

  /// N, NAME, auto or auto:D; a whole number is always a face's. The usual
  /// choice if the text is empty. Nothing if it is none of these; `defect` then
  /// says why. May be called from several threads.
  std::optional<FaceChoice> Parse(std::string_view text, std::string& defect);

  /// What an empty text means; without it: no face.
  void SetUsual(const FaceChoice& usual) { usual_ = usual; }

  [[nodiscard]] const FaceChoice& usual() const { return usual_; }

  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  std::optional<FaceChoice> ParseAuto(const std::string& word,
                                      std::string& defect);
  [[nodiscard]] bool IsName(const std::string& word);
  FaceChoice SearchOf(const std::string& word, const FaceSearch& search);

  const Scene& scene_;
  FaceChoice usual_;
  std::mutex mutex_;                            ///< of searches_
  std::map<std::string, FaceSearch> searches_;  ///< by what the text says
};

/// How searches for faces went.
struct FoundFaces {
  std::uint64_t searched = 0;  ///< receivers
  std::uint64_t found = 0;     ///< of these, with a face
  double farthest = 0;         ///< the largest distance to a face found
  std::uint64_t unsure = 0;    ///< of the found, with a second face near

  FoundFaces& operator+=(const FoundFaces& other);
};

/// Sets the receiver's face. Counts, if it had to be searched for. May be
/// called from several threads with counts of their own.
void SetFace(const Scene& scene, const FaceChoice& choice, Receiver& receiver,
             FoundFaces& counts);

/// One sentence; "" if nothing was searched for.
[[nodiscard]] std::string FoundFacesText(const FoundFaces& counts);

/// One sentence that names the option --on-face; "" if there are none. dark: so
/// many of `receivers` get 0 and lie behind a face, see Scene::IsBehindFace.
[[nodiscard]] std::string BehindFacesText(std::uint64_t dark,
                                          std::uint64_t receivers);

}  // namespace truelux

#endif  // TRUELUX_TEXT_FACE_CHOICE_H_
