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

/// A name that is known already is a broken caller: a table names each thing once.
void CheckIsNew(std::string_view kind, std::string_view name,
                const std::vector<std::string>& known);

/// "a, b, c".
std::string Join(const std::vector<std::string>& words, std::string_view separator = ", ");

/// `first`, then the words of the text, in lines of at most `columns` that go on at column `indent`;
/// a `first` that reaches so far stands in a line of its own. Ends with a newline.
std::string Wrapped(std::string first, std::string_view text, std::size_t indent,
                    std::size_t columns = 100);

/// "3, 7, 12 and 40 more": a list of ids for a message, cut after `limit` of them.
std::string IdList(const std::vector<int>& ids, int limit = 10);

}  // namespace cirque
