package org.maestro.language.chart;

import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.maestro.language.grammar.Form;

/** What words are in a lexicon: by their category, with what they mean. */
public interface WordEntries {
  /** The category of whichever word. */
  String ANY = "Any";

  /** The category of whichever word with which it may begin what somebody is told. */
  String OPENING = "Opening";

  /** The categories of which words are that nobody has to know. */
  Set<String> FREE = Set.of(ANY, OPENING);

  /**
   * One or several words that are one symbol of the grammar.
   *
   * @param words so many words at the end of those asked for
   */
  record Entry(String category, int words, Form meaning) {}

  /** The entries that the last words are. */
  List<Entry> endingWith(List<String> words);

  /** Whether these are the first of more words that are an entry of such a category. */
  boolean isBeginning(List<String> words, Predicate<String> categories);

  /** Of how many words the longest entry is. */
  int longest();

  /**
   * Words with which an entry of such a category goes on, or begins.
   *
   * @param words with which it has begun; none: it is to begin
   * @param begin of the words that are wanted
   * @param most so many at most
   */
  Set<String> next(List<String> words, Predicate<String> categories, String begin, int most);
}
