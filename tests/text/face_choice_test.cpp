// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/face_choice.h"

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

/// Faces 1 and 2 at the heights 0 and 5, objects Low and High; "2" is a group.
Scene TwoFloors() {
  return SceneFromText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\n"
      "o Low\nf 1 2 3\no High end\ng 2\nf 4 5 6\n");
}

class FaceTexts : public testing::Test {
 protected:
  /// The face that a text gives to a receiver at this height; -1: a defect.
  int FaceAt(double z, const std::string& text) {
    defect_.clear();
    const auto choice = words_.Parse(text, defect_);
    if (!choice) return -1;
    Receiver receiver{{0.75, 0.25, z}, {0, 0, 1}};
    SetFace(scene_, *choice, receiver, counts_);
    return receiver.on_face;
  }

  Scene scene_ = TwoFloors();
  FaceWords words_{scene_};
  FoundFaces counts_;
  std::string defect_;
};

TEST_F(FaceTexts, NumbersAreFaces) {
  EXPECT_EQ(FaceAt(3, "2"), 2);
  EXPECT_EQ(FaceAt(3, " 1.0 "), 1);
  EXPECT_EQ(FaceAt(3, ""), 0);
  EXPECT_EQ(counts_.searched, 0U);
}

TEST_F(FaceTexts, NamesAreSearches) {
  EXPECT_EQ(FaceAt(3, "Low"), 1);
  EXPECT_EQ(FaceAt(1, "High end"), 2);
  EXPECT_EQ(FaceAt(1, "High end/2"), 2);
  EXPECT_EQ(counts_.searched, 3U);
  EXPECT_EQ(counts_.found, 3U);
  EXPECT_EQ(counts_.farthest, 4);
}

TEST_F(FaceTexts, AutoFindsWhatIsNear) {
  EXPECT_EQ(FaceAt(-1e-7, "auto"), 1);
  EXPECT_EQ(FaceAt(5 + 1e-7, "auto"), 2);
  EXPECT_EQ(FaceAt(1, "auto"), 0);
  EXPECT_EQ(FaceAt(1, "auto:1"), 1);
  EXPECT_EQ(FaceAt(1, "auto:0.5"), 0);
  EXPECT_EQ(FaceAt(1, "auto:1e9"), 1);
  EXPECT_EQ(counts_.searched, 6U);
  EXPECT_EQ(counts_.found, 4U);
  EXPECT_EQ(counts_.unsure, 1U);
}

TEST_F(FaceTexts, AnEmptyTextIsTheUsualChoice) {
  std::string defect;
  words_.SetUsual(*words_.Parse("auto:1", defect));
  EXPECT_EQ(FaceAt(1, ""), 1);
  EXPECT_EQ(FaceAt(1, " "), 1);
  EXPECT_EQ(FaceAt(1, "2"), 2);
}

TEST_F(FaceTexts, DefectsSayWhatIsWrong) {
  EXPECT_EQ(FaceAt(0, "3"), -1);
  EXPECT_EQ(defect_, "'3' is out of range; the scene has 2 faces");
  EXPECT_EQ(FaceAt(0, "-1"), -1);
  EXPECT_EQ(FaceAt(0, "1.5"), -1);
  EXPECT_EQ(defect_,
            "'1.5' is not the number of a face, the name of an object or "
            "group, or auto");
  EXPECT_EQ(FaceAt(0, "Cellar"), -1);
  for (const char* text : {"auto:", "auto:x", "auto:-1", "auto:1e999"}) {
    EXPECT_EQ(FaceAt(0, text), -1);
    EXPECT_EQ(defect_, "'" + std::string(text) +
                           "': expected auto, or auto:D with a distance D from "
                           "0 upwards");
  }
}

TEST(FaceSentences, CountWhatWasFound) {
  EXPECT_EQ(FoundFacesText({}), "");
  EXPECT_EQ(FoundFacesText({5, 0, 0, 0}), "0 of 5 receivers lie on a face");
  FoundFaces counts{5, 4, 1.25e-7, 1};
  EXPECT_EQ(
      FoundFacesText(counts),
      "4 of 5 receivers lie on a face, at most 1.25e-7 away; 1 of them is "
      "near to a second face, too");
  counts += {1, 1, 0.5, 1};
  EXPECT_EQ(
      FoundFacesText(counts),
      "5 of 6 receivers lie on a face, at most 5.00e-1 away; 2 of them are "
      "near to a second face, too");
}

TEST(FaceSentences, NameTheOption) {
  EXPECT_EQ(BehindFacesText(0, 7), "");
  EXPECT_EQ(BehindFacesText(1, 7),
            "1 of 7 receivers gets 0 and lies behind a face, no farther than "
            "rounding moves a point; --on-face auto takes it as lying on it");
}

}  // namespace
}  // namespace truelux
