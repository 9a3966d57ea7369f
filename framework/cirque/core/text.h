#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cirque {

/// The known word with the least edit distance to `word`; empty when none is near enough to be a
/// misspelling.
std::string NearestWord(std::string_view word, const std::vector<std::string>& known);

/// "unknown KIND 'NAME'; did you mean 'X'? Known: a, b, c": the one wording for every unknown name.
std::string UnknownName(std::string_view kind, std::string_view name,
                        const std::vector<std::string>& known);

/// "a, b, c".
std::string Join(const std::vector<std::string>& words, std::string_view separator = ", ");

/// "3, 7, 12 and 40 more": a list of ids for a message, cut after `limit` of them.
std::string IdList(const std::vector<int>& ids, int limit = 10);

}  // namespace cirque
