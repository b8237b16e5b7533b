// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "scene/graph_layout.h"

namespace betwixt {
namespace {

class GraphReader {
 public:
  explicit GraphReader(std::string_view text) : text_(text) {}

  Result<Graph> all() {
    while (at_ < text_.size()) {
      if (skip(" \t\r\n;"), at_ >= text_.size()) break;
      if (Status s = chain(); !s) return s.error();
    }
    if (graph_.nodes.empty()) return wrong("a diagram needs at least one node", 0);
    return std::move(graph_);
  }

 private:
  Error wrong(std::string message, std::size_t at, ErrorCode code = ErrorCode::syntax) const {
    Error e = fail(code, std::move(message), "as in of=\"a -> b -> c; a -> d\"");
    e.place.column = static_cast<int>(at) + 1, e.place.length = 1;
    return e;
  }
  void skip(std::string_view blanks) {
    while (at_ < text_.size() && blanks.find(text_[at_]) != std::string_view::npos) ++at_;
  }
  bool here(std::string_view s) const { return text_.substr(at_, s.size()) == s; }

  // Reads A -> B -- C … [: LABEL].
  Status chain() {
    const std::size_t first = graph_.edges.size();
    std::size_t before = 0;
    if (Status s = node(before); !s) return s;
    while (skip(" \t"), here("->") || here("--")) {
      const bool arrow = here("->");
      at_ += 2;
      skip(" \t");
      std::size_t next = 0;
      if (Status s = node(next); !s) return s;
      graph_.edges.push_back({before, next, arrow, {}});
      if (graph_.edges.size() > most_graph_edges)
        return wrong(fmt::format("a diagram can have at most {} edges", most_graph_edges), at_, ErrorCode::range);
      before = next;
    }
    if (at_ < text_.size() && text_[at_] == ':') {
      if (first == graph_.edges.size()) return wrong("a label needs an edge before it", at_);
      ++at_, skip(" \t");
      const std::size_t end = std::min(text_.find_first_of(";\n", at_), text_.size());
      std::string label(text_.substr(at_, end - at_));
      label.erase(label.find_last_not_of(" \t\r") + 1);
      for (std::size_t i = first; i < graph_.edges.size(); ++i) graph_.edges[i].label = label;
      at_ = end;
    }
    if (at_ < text_.size() && text_[at_] != ';' && text_[at_] != '\n' && text_[at_] != '\r')
      return wrong("expected ->, -- or ; here", at_);
    return Nothing{};
  }

  Status node(std::size_t& number) {
    const std::size_t start = at_;
    std::string name;
    if (at_ < text_.size() && text_[at_] == '\'') {
      const std::size_t end = text_.find('\'', at_ + 1);
      if (end == text_.npos) return wrong("this text is not closed; end it with '", start);
      name = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
    } else {
      while (at_ < text_.size() && !here("->") && !here("--") && text_.find_first_of(";:\n\r", at_) != at_) ++at_;
      name = text_.substr(start, at_ - start);
      name.erase(name.find_last_not_of(" \t") + 1);
    }
    if (name.empty()) return wrong("a node is missing here", start);
    if (text_[start] != '\'')
      if (const std::size_t odd = name.find_first_of(",<>=|[]{}\""); odd != name.npos)
        return wrong(name.compare(odd, 2, "=>") == 0 ? "an arrow is written ->"
                                                     : "a text with such a sign must stand in single quotes",
                     start + odd);
    const auto [it, fresh] = known_.try_emplace(name, graph_.nodes.size());
    if (fresh) graph_.nodes.push_back(name);
    if (graph_.nodes.size() > most_graph_nodes)
      return wrong(fmt::format("a diagram can have at most {} nodes", most_graph_nodes), start, ErrorCode::range);
    number = it->second;
    return Nothing{};
  }

  const std::string_view text_;
  std::size_t at_ = 0;
  Graph graph_;
  std::unordered_map<std::string, std::size_t> known_;
};

}  // namespace

Result<Graph> read_graph(std::string_view text) { return GraphReader(text).all(); }

}  // namespace betwixt
