// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The journal must be complete up to the last written record, whatever happens to the file.
#include "editor/journal.h"

#include <algorithm>

#include "editor/author.h"

namespace betwixt {
namespace {

// shows: G22
TEST(Journal, ATornRecordIsSeenAndDroppedWhereverItWasCut) {
  const Folder folder;
  std::vector<std::size_t> sizes;
  {
    auto j = *Journal::open(folder / "j");
    ASSERT_TRUE(j->begin(fingerprint("text")));
    sizes.push_back(folder.get("j").size());
    for (const char* line : {"set a.b 1", "at 1f a.text \"é\n\"", "rate 25"}) {
      ASSERT_TRUE(j->append(Did::command, line));
      sizes.push_back(folder.get("j").size());
    }
  }
  const std::string whole = folder.get("j");
  for (std::size_t cut = sizes[0]; cut <= whole.size(); ++cut) {
    folder.put("j", whole.substr(0, cut));
    auto j = *Journal::open(folder / "j");
    const auto kept = std::count_if(sizes.begin() + 1, sizes.end(), [&](std::size_t n) { return n <= cut; });
    EXPECT_EQ(j->records().size(), static_cast<std::size_t>(kept)) << cut;
    EXPECT_FALSE(j->damaged()) << cut;
    EXPECT_EQ(j->torn() > 0, std::find(sizes.begin(), sizes.end(), cut) == sizes.end()) << cut;
    ASSERT_TRUE(j->append(Did::undo, ""));
    j.reset();
    EXPECT_EQ((*Journal::open(folder / "j"))->records().size(), static_cast<std::size_t>(kept) + 1) << cut;
  }
  for (std::size_t at = sizes[1]; at < sizes[2]; ++at) {  // a bit that has changed
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    folder.put("j", changed);
    EXPECT_LE((*Journal::open(folder / "j"))->records().size(), 1u) << at;
  }
}

// What is answered is kept: where the journal is no longer under its name, nothing is taken.
// shows: G22
TEST(Journal, OneThatVanishesTakesNothingMore) {
  for (const bool replaced : {false, true}) {
    const Folder folder;
    auto j = *Journal::open(folder / "j");
    ASSERT_TRUE(j->begin(fingerprint("text")));
    ASSERT_TRUE(j->append(Did::command, "rate 24"));
    std::filesystem::rename(folder / "j", folder / "away");
    if (replaced) folder.put("j", folder.get("away"));
    const Status lost = j->append(Did::command, "rate 25");
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().code, ErrorCode::machine);
    std::filesystem::rename(folder / "away", folder / "j");
    ASSERT_TRUE(j->append(Did::command, "rate 30")) << "it is back";
    std::filesystem::remove(folder / "j");
    EXPECT_FALSE(j->append(Did::undo, ""));
    ASSERT_TRUE(j->begin(fingerprint("text"))) << "a new one";
    EXPECT_TRUE(j->append(Did::command, "rate 50"));
    j.reset();
    EXPECT_EQ((*Journal::open(folder / "j"))->records().size(), 1u);
  }
}

}  // namespace
}  // namespace betwixt
