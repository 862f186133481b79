package org.maestro.language.chart;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;

/**
 * The chart of one utterance. Grows by a column with each word that fits, and is cut back when
 * words are taken back. Time for a word grows with the number of rules that are under way, not with
 * that of the rules there are. Not safe for threads.
 */
public final class Chart {
  /** So many readings of what was said so far are made at most. */
  private static final int PARTIAL = 400;

  /** So deep a phrase stands in others at most. */
  private static final int DEEPEST = 24;

  private final RuleIndex rules;
  private final WordEntries lexicon;
  private final Predicate<Form> possible;
  private final List<Column> columns = new ArrayList<>();
  private final List<String> words = new ArrayList<>();

  /**
   * An empty chart.
   *
   * @param possible whether something can be meant at all; what cannot is left out at once
   */
  public Chart(RuleIndex rules, WordEntries lexicon, Predicate<Form> possible) {
    this.rules = rules;
    this.lexicon = lexicon;
    this.possible = possible;
    Column first = new Column(rules);
    first.predict(Grammar.START);
    columns.add(first);
  }

  /** How many words it holds. */
  public int size() {
    return words.size();
  }

  /** The words it holds. */
  public List<String> words() {
    return List.copyOf(words);
  }

  /**
   * Takes one more word.
   *
   * @return false: it does not fit, nor would it begin several words that do; the chart is as it
   *     was
   */
  public boolean extend(String word) {
    return extend(word, true);
  }

  /**
   * The same.
   *
   * @param freely whether it may also be one of whichever words are allowed somewhere
   */
  public boolean extend(String word, boolean freely) {
    words.add(word);
    Column next = new Column(rules);
    columns.add(next);
    Symbol literal = new Symbol.Word(word);
    Column last = columns.get(columns.size() - 2);
    for (Derivation waiting : last.awaiting(literal)) {
      advance(waiting, Form.leaf(word), 0);
    }
    begin(literal, columns.size() - 2, Form.leaf(word), 0);
    for (WordEntries.Entry entry : lexicon.endingWith(words)) {
      int origin = words.size() - entry.words();
      if ((freely || !WordEntries.FREE.contains(entry.category()))
          && columns.get(origin).predicts(entry.category())) {
        complete(entry.category(), origin, entry.meaning(), 0);
      }
    }
    if (next.isEmpty() && !beginsAnEntry()) {
      cut(words.size() - 1);
      return false;
    }
    return true;
  }

  private boolean beginsAnEntry() {
    for (int from = words.size() - 1; from >= 0; from--) {
      if (words.size() - from > lexicon.longest()) {
        return false;
      }
      if (lexicon.isBeginning(words.subList(from, words.size()), columns.get(from)::predicts)) {
        return true;
      }
    }
    return false;
  }

  /** Forgets all but the first words. */
  public void cut(int size) {
    while (words.size() > size) {
      words.remove(words.size() - 1);
      columns.remove(columns.size() - 1);
    }
  }

  private void begin(Symbol first, int origin, Form form, int penalty) {
    Column from = columns.get(origin);
    for (Rule rule : rules.beginningWith(first)) {
      if (from.predicts(rule.category())) {
        advance(Derivation.begun(rule, origin), form, penalty);
      }
    }
  }

  private void advance(Derivation derivation, Form form, int penalty) {
    Derivation advanced = derivation.advanced(form, penalty);
    if (!advanced.isComplete()) {
      columns.get(columns.size() - 1).add(advanced);
    } else {
      complete(advanced.rule().category(), advanced.origin(), advanced.form(), advanced.penalty());
    }
  }

  private void complete(String category, int origin, Form form, int penalty) {
    Column last = columns.get(columns.size() - 1);
    if (!possible.test(form) || !last.add(new Column.Part(category, origin), form, penalty)) {
      return;
    }
    Symbol symbol = new Symbol.Category(category);
    for (Derivation waiting : columns.get(origin).awaiting(symbol)) {
      advance(waiting, form, penalty);
    }
    begin(symbol, origin, form, penalty);
  }

  /** The readings of all words as a whole utterance, the usual ones first. */
  public List<Reading> complete() {
    return columns.get(columns.size() - 1).readings(Grammar.START, 0).stream()
        .sorted(Comparator.comparingInt(Reading::penalty))
        .toList();
  }

  /** The rules by which a reading of all words came about. */
  public Set<Rule> rules(Reading reading) {
    return new Ancestry(columns, words, rules).of(reading);
  }

  /**
   * The readings of what was said so far, those of whole utterances first; what is still to be said
   * is a hole.
   *
   * @param wanted of which forms, whole and in part, readings are made
   */
  public List<Reading> partial(Predicate<Form> wanted) {
    List<Reading> found = new ArrayList<>(complete());
    begun(derivation -> true, wanted, found);
    return found.stream().distinct().sorted(Comparator.comparingInt(Reading::penalty)).toList();
  }

  /**
   * The readings in which a form of this head was begun last, and is not whole; not those of which
   * nothing but a few words of the rule was said, and a word lacks next.
   */
  public List<Reading> begun(String head) {
    List<Reading> found = new ArrayList<>();
    begun(
        derivation ->
            derivation.form().is(head)
                && (derivation.awaited() instanceof Symbol.Category
                    || derivation.isOfMoreThanWords()),
        possible,
        found);
    return found.stream().distinct().sorted(Comparator.comparingInt(Reading::penalty)).toList();
  }

  private void begun(Predicate<Derivation> first, Predicate<Form> wanted, List<Reading> found) {
    for (Derivation derivation : columns.get(columns.size() - 1).all()) {
      if (first.test(derivation)) {
        climb(derivation, derivation.form(), 0, wanted, found);
      }
    }
  }

  private void climb(
      Derivation derivation, Form form, int depth, Predicate<Form> wanted, List<Reading> found) {
    if (found.size() >= PARTIAL || depth > DEEPEST || !wanted.test(form)) {
      return;
    }
    if (derivation.origin() == 0 && derivation.rule().category().equals(Grammar.START)) {
      found.add(new Reading(form, derivation.penalty()));
    }
    Column origin = columns.get(derivation.origin());
    Symbol own = new Symbol.Category(derivation.rule().category());
    for (Derivation waiting : origin.awaiting(own)) {
      Derivation through = waiting.advanced(form, derivation.penalty());
      climb(through, through.form(), depth + 1, wanted, found);
    }
    for (Rule rule : rules.beginningWith(own)) {
      if (origin.predicts(rule.category()) && !rule.category().equals(own(own))) {
        Derivation through =
            Derivation.begun(rule, derivation.origin()).advanced(form, derivation.penalty());
        climb(through, through.form(), depth + 1, wanted, found);
      }
    }
  }

  private static String own(Symbol category) {
    return ((Symbol.Category) category).name();
  }

  /** Whether what was said last is of this category, and more could belong to it. */
  public boolean isOpenAfter(String category) {
    Symbol last = new Symbol.Category(category);
    return columns.get(columns.size() - 1).all().stream().anyMatch(one -> one.isAfter(last));
  }

  /** Whether a word of this category could come next. */
  public boolean predicts(String category) {
    return columns.get(columns.size() - 1).predicts(category);
  }

  /**
   * Words that could come next, and begin so, in the order of their letters: those of the grammar,
   * and those of entries that begin here, or have begun before.
   *
   * @param begin of them; "" of whichever
   * @param most so many at most
   */
  public List<String> next(String begin, int most) {
    Column last = columns.get(columns.size() - 1);
    Set<String> next = new TreeSet<>();
    last.awaited().forEach(symbol -> wordOf(symbol).ifPresent(next::add));
    last.predicted().forEach(category -> next.addAll(rules.firstWords(category)));
    next.removeIf(word -> !word.startsWith(begin));
    int size = words.size();
    for (int from = size; from >= 0 && size - from < lexicon.longest(); from--) {
      next.addAll(
          lexicon.next(words.subList(from, size), columns.get(from)::predicts, begin, most));
    }
    return next.stream().filter(Chart::isOneWord).limit(most).toList();
  }

  /** Whether people would write it by itself. */
  private static boolean isOneWord(String word) {
    return word.codePoints().allMatch(c -> Character.isLetterOrDigit(c) || c == '-' || c == '\'')
        && Character.isLetterOrDigit(word.codePointAt(0));
  }

  private static Optional<String> wordOf(Symbol symbol) {
    return symbol instanceof Symbol.Word word ? Optional.of(word.text()) : Optional.empty();
  }
}
