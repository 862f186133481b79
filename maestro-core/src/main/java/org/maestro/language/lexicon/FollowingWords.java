package org.maestro.language.lexicon;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;

/** With which words entries begin, and go on. Not changed any more when the lexicon is read. */
final class FollowingWords {
  private final Map<List<String>, Map<String, NavigableSet<String>>> byBeginning = new HashMap<>();

  void add(List<String> entry, String category) {
    for (int size = 0; size < entry.size(); size++) {
      byBeginning
          .computeIfAbsent(List.copyOf(entry.subList(0, size)), b -> new HashMap<>())
          .computeIfAbsent(category, c -> new TreeSet<>())
          .add(entry.get(size));
    }
  }

  /**
   * The words with which an entry of such a category goes on.
   *
   * @param words with which it has begun; none: it is to begin
   * @param begin of the words that are wanted
   * @param most so many of a category at most, the first by their letters
   */
  Set<String> after(List<String> words, Predicate<String> categories, String begin, int most) {
    Set<String> next = new TreeSet<>();
    byBeginning
        .getOrDefault(words, Map.of())
        .forEach(
            (category, following) -> {
              if (categories.test(category)) {
                following.tailSet(begin, true).stream()
                    .takeWhile(word -> word.startsWith(begin))
                    .limit(most)
                    .forEach(next::add);
              }
            });
    return next;
  }
}
