package org.maestro.language.hearing;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.maestro.language.chart.Chart;
import org.maestro.language.chart.Reading;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;
import org.maestro.language.lexicon.Lexicon;
import org.maestro.language.lexicon.Tokens;

/**
 * The words of one utterance while it is heard. A word that does not fit is a filler, the beginning
 * of a repair, a repetition, misheard, or stays unplaced: then nothing is understood until the
 * speaker corrects it. Not safe for threads.
 */
public final class HeardWords {
  /** Nobody says more words in one breath; of more of them nothing is understood. */
  private static final int LONGEST = 120;

  private final Grammar grammar;
  private final Lexicon lexicon;
  private final Supplier<Chart> fresh;
  private final Set<String> grammarWords;
  private final Set<String> foreign;
  private final List<Heard> heard = new ArrayList<>();
  private final List<String> withdrawn = new ArrayList<>();
  private Chart chart;
  private List<String> held = List.of();
  private boolean repairing;
  private int repairs;
  private boolean hesitating;
  private boolean blocked;
  private boolean tooLong;
  private Optional<Resumption> resumption = Optional.empty();

  /**
   * Where the speaker went on after a repair.
   *
   * @param before the words until then
   * @param column after how many of them he went on
   * @param since the words after it
   */
  private record Resumption(List<String> before, int column, List<String> since) {}

  /**
   * Nothing was heard yet.
   *
   * @param grammarWords those with which the grammar's rules speak
   * @param foreign words that are known elsewhere: who says one means it
   */
  public HeardWords(
      Grammar grammar,
      Set<String> grammarWords,
      Set<String> foreign,
      Lexicon lexicon,
      Supplier<Chart> fresh) {
    this.grammar = grammar;
    this.grammarWords = grammarWords;
    this.foreign = foreign;
    this.lexicon = lexicon;
    this.fresh = fresh;
    this.chart = fresh.get();
  }

  /** The words with which rules of a grammar speak. */
  public static Set<String> wordsOf(Grammar grammar) {
    Set<String> words = new HashSet<>();
    for (Rule rule : grammar.rules()) {
      rule.symbols().stream()
          .filter(Symbol.Word.class::isInstance)
          .forEach(symbol -> words.add(((Symbol.Word) symbol).text()));
    }
    words.addAll(grammar.numbers().keySet());
    words.addAll(grammar.times().keySet());
    return words;
  }

  /** Takes the next word. */
  public void take(String word) {
    if (heard.size() + held.size() >= LONGEST) {
      tooLong = true;
      held.forEach(this::notPlaced);
      held = List.of();
      notPlaced(word);
      return;
    }
    List<String> sequence = new ArrayList<>(held);
    sequence.add(word);
    if (!held.isEmpty()) {
      if (isListed("repair", sequence)) {
        held = List.of();
        note(sequence, Heard.Fate.REPAIR);
        repair();
        return;
      }
      if (isListed("filler", sequence)) {
        held = List.of();
        note(sequence, Heard.Fate.FILLER);
        hesitating = true;
        return;
      }
      if (begins(sequence)) {
        held = sequence;
        return;
      }
      List<String> before = held;
      held = List.of();
      before.forEach(one -> place(one, false));
    }
    place(word, true);
  }

  /** Nothing more is said. */
  public void end() {
    if (tooLong) {
      return;
    }
    List<String> before = held;
    held = List.of();
    before.forEach(one -> place(one, false));
    while (!blocked && chart.complete().isEmpty() && letGo()) {
      repairing = false;
    }
    if (!blocked && chart.complete().isEmpty() && !goesOnAsBefore() && !isWholeWithoutBreaths()) {
      resumption.ifPresent(this::goOnEarlier);
    }
    if (chart.complete().isEmpty()) {
      heard.replaceAll(
          word ->
              word.fate() == Heard.Fate.TAKEN && !isKnown(word.word())
                  ? new Heard(word.word(), Heard.Fate.UNKNOWN)
                  : word);
    }
  }

  private void repair() {
    // The breath before it is no part of what goes on.
    while (!chart.words().isEmpty() && isListed("filler", last(chart.words()))) {
      List<String> idle = last(chart.words());
      chart.cut(chart.size() - 1);
      renote(idle, Heard.Fate.FILLER);
    }
    repairing = true;
    blocked = false;
    repairs++;
    List<String> before = chart.words();
    resumption = Optional.of(new Resumption(before, before.size(), List.of()));
  }

  private static List<String> last(List<String> words) {
    return words.subList(words.size() - 1, words.size());
  }

  private boolean isListed(String list, List<String> words) {
    return grammar.list(list).contains(words);
  }

  /** Whether more words are to come before it is known what these are. */
  private boolean begins(List<String> words) {
    return List.of("repair", "filler").stream()
        .flatMap(name -> grammar.list(name).stream())
        .anyMatch(
            entry -> entry.size() > words.size() && entry.subList(0, words.size()).equals(words));
  }

  private void note(List<String> words, Heard.Fate fate) {
    words.forEach(word -> heard.add(new Heard(word, fate)));
  }

  private void place(String word, boolean mayHold) {
    if (word.equals(Tokens.CUT_OFF)) {
      heard.add(new Heard(word, Heard.Fate.REPAIR));
      repair();
      return;
    }
    if (repairing && isListed("filler", List.of(word))) {
      heard.add(new Heard(word, Heard.Fate.FILLER));
      return;
    }
    if (!blocked && repairing && isSaidAgain(word)) {
      heard.add(new Heard(word, Heard.Fate.TAKEN));
      taken(word);
      return;
    }
    if (!blocked && isStuttered(word)) {
      heard.add(new Heard(word, Heard.Fate.REPAIR));
      return;
    }
    // After a repair, a word is not one of whichever words that somebody is to be told.
    if (!blocked && chart.extend(word, !repairing)) {
      heard.add(new Heard(word, Heard.Fate.TAKEN));
      taken(word);
      return;
    }
    List<String> alone = List.of(word);
    if (mayHold && begins(alone)) {
      held = alone;
      return;
    }
    if (!blocked && letGoWith(word)) {
      return;
    }
    if (isListed("repair", alone)) {
      heard.add(new Heard(word, Heard.Fate.REPAIR));
      repair();
    } else if (isListed("filler", alone)) {
      heard.add(new Heard(word, Heard.Fate.FILLER));
      hesitating = true;
    } else if (!blocked && letGo()) {
      place(word, mayHold);
    } else if (blocked) {
      notPlaced(word);
    } else if (mayResume(word) && goOnEarlier(word)) {
      heard.add(new Heard(word, Heard.Fate.TAKEN));
      repairing = false;
      hesitating = false;
    } else {
      misheard(word);
    }
  }

  /**
   * What was taken last may have been a filler, or the beginning of a repair, though it had a place
   * in the sentence: it is let go, if it was.
   */
  private boolean letGo() {
    List<String> words = chart.words();
    for (int size = Math.min(2, words.size()); size > 0; size--) {
      List<String> last = words.subList(words.size() - size, words.size());
      for (String list : List.of("repair", "filler")) {
        if (isListed(list, last)) {
          chart.cut(words.size() - size);
          boolean isRepair = list.equals("repair");
          renote(last, isRepair ? Heard.Fate.REPAIR : Heard.Fate.FILLER);
          if (isRepair) {
            repair();
          }
          hesitating = true;
          return true;
        }
      }
    }
    return false;
  }

  /** The word may be the last of several that begin a repair, of which the others had a place. */
  private boolean letGoWith(String word) {
    List<String> words = chart.words();
    for (int size = 1; size <= Math.min(2, words.size()); size++) {
      List<String> others = List.copyOf(words.subList(words.size() - size, words.size()));
      List<String> all = new ArrayList<>(others);
      all.add(word);
      if (isListed("repair", all)) {
        chart.cut(words.size() - size);
        renote(others, Heard.Fate.REPAIR);
        heard.add(new Heard(word, Heard.Fate.REPAIR));
        repair();
        return true;
      }
    }
    return false;
  }

  private void renote(List<String> words, Heard.Fate fate) {
    int at = heard.size() - 1;
    for (int i = words.size() - 1; i >= 0; i--) {
      while (at >= 0 && heard.get(at).fate() != Heard.Fate.TAKEN) {
        at--;
      }
      if (at >= 0) {
        heard.set(at, new Heard(heard.get(at).word(), fate));
      }
    }
  }

  private boolean mayResume(String word) {
    List<String> words = chart.words();
    // What is told to somebody may say a word twice.
    boolean isStutter = !words.isEmpty() && words.get(words.size() - 1).equals(word);
    return resumption.isPresent() || isStutter || hesitating && words.contains(word);
  }

  private void taken(String word) {
    repairing = false;
    hesitating = false;
    resumption =
        resumption.map(
            last -> {
              List<String> since = new ArrayList<>(last.since());
              since.add(word);
              return new Resumption(last.before(), last.column(), List.copyOf(since));
            });
  }

  /** An article that is said twice is one, where nothing is called so. */
  private boolean isStuttered(String word) {
    List<String> words = chart.words();
    return isListed("article", List.of(word))
        && !words.isEmpty()
        && words.get(words.size() - 1).equals(word)
        && !lexicon.isBeginning(List.of(word, word), category -> true)
        && lexicon.endingWith(List.of(word, word)).stream().noneMatch(entry -> entry.words() == 2);
  }

  /** Who begins again with a word takes back what he said since it: in A, I mean in B. */
  private boolean isSaidAgain(String word) {
    List<String> before = chart.words();
    int column = before.lastIndexOf(word);
    if (column < 0) {
      return false;
    }
    chart.cut(column);
    if (!chart.extend(word, false)) {
      restore(before);
      return false;
    }
    withdraw(before.subList(column, before.size()));
    resumption = Optional.of(new Resumption(before, column, List.of()));
    return true;
  }

  /**
   * Goes on after the last word after which this one fits, with what was said since the repair;
   * what was said between is withdrawn.
   */
  private boolean goOnEarlier(String word) {
    List<String> now = chart.words();
    Resumption last = resumption.orElseGet(() -> new Resumption(now, now.size(), List.of()));
    List<String> since = new ArrayList<>(last.since());
    since.add(word);
    return goOnEarlier(last, since, false);
  }

  private boolean goOnEarlier(Resumption last) {
    return goOnEarlier(last, last.since(), true);
  }

  private boolean goOnEarlier(Resumption last, List<String> since, boolean whole) {
    List<String> now = chart.words();
    restore(last.before());
    for (int column = last.column() - 1; column >= 0; column--) {
      chart.cut(column);
      if (since.stream().allMatch(one -> chart.extend(one, false))
          && (!whole || !chart.complete().isEmpty())) {
        withdraw(last.before().subList(column, last.before().size()));
        resumption = Optional.of(new Resumption(last.before(), column, List.copyOf(since)));
        return true;
      }
    }
    restore(now);
    return false;
  }

  /** What was said after what is corrected counts still, where the sentence lacks it. */
  private boolean goesOnAsBefore() {
    if (resumption.isEmpty() || resumption.get().since().isEmpty()) {
      return false;
    }
    Resumption last = resumption.get();
    List<String> before = last.before();
    int size = chart.size();
    for (int from = before.size() - 1; from > last.column(); from--) {
      if (before.subList(from, before.size()).stream().allMatch(one -> chart.extend(one, false))
          && !chart.complete().isEmpty()) {
        return true;
      }
      chart.cut(size);
    }
    return false;
  }

  /** A breath may have been taken for one between two of a list. */
  private boolean isWholeWithoutBreaths() {
    List<String> words = chart.words();
    List<String> others = words.stream().filter(word -> !word.equals(Tokens.BREATH)).toList();
    chart = fresh.get();
    if (others.size() < words.size()
        && others.stream().allMatch(chart::extend)
        && !chart.complete().isEmpty()) {
      return true;
    }
    restore(words);
    return false;
  }

  private void withdraw(List<String> words) {
    withdrawn.clear();
    withdrawn.addAll(words);
  }

  private void restore(List<String> words) {
    chart = fresh.get();
    words.forEach(chart::extend);
  }

  /** Whether it is a word for something in the home, rather than of the language alone. */
  public boolean isOfTheHome(String word) {
    return lexicon.knows(word) && !grammarWords.contains(word);
  }

  private boolean isKnown(String word) {
    return lexicon.knows(word) || grammarWords.contains(word);
  }

  private void misheard(String word) {
    if (!isKnown(word) && !foreign.contains(word)) {
      Stream<String> all = Stream.concat(grammarWords.stream(), lexicon.words().stream());
      List<String> fitting = Nearby.of(word, all).stream().filter(this::fits).toList();
      if (fitting.size() == 1) {
        chart.extend(fitting.get(0));
        heard.add(new Heard(word, Heard.Fate.MISHEARD, Optional.of(fitting.get(0))));
        taken(fitting.get(0));
        return;
      }
    }
    blocked = true;
    notPlaced(word);
  }

  private void notPlaced(String word) {
    heard.add(new Heard(word, isKnown(word) ? Heard.Fate.UNPLACED : Heard.Fate.UNKNOWN));
  }

  private boolean fits(String word) {
    boolean fits = chart.extend(word);
    if (fits) {
      chart.cut(chart.size() - 1);
    }
    return fits;
  }

  /** The chart of what was meant to be said; nothing fits it while a word stays unplaced. */
  public Chart chart() {
    return chart;
  }

  /**
   * Words that could come next, and begin so; none while a word stays unplaced.
   *
   * @param begin of them; "" of whichever
   * @param most so many at most
   */
  public List<String> next(String begin, int most) {
    return isBlocked() ? List.of() : chart.next(begin, most);
  }

  /** How often the speaker has taken something back. */
  public int repairs() {
    return repairs;
  }

  /** Whether a word was heard that fits nothing, or too many were. */
  public boolean isBlocked() {
    return blocked || tooLong;
  }

  /** None of the words, to hear others. */
  public HeardWords afresh() {
    return new HeardWords(grammar, grammarWords, foreign, lexicon, fresh);
  }

  /** Whether more words were heard than anybody says in one breath. */
  public boolean isTooLong() {
    return tooLong;
  }

  /** What became of each word. */
  public List<Heard> heard() {
    return List.copyOf(heard);
  }

  /** The words that the last repair took back. */
  public List<String> withdrawn() {
    return List.copyOf(withdrawn);
  }

  /** The readings of all that was said; none while a word stays unplaced. */
  public List<Reading> readings() {
    return isBlocked() ? List.of() : chart.complete();
  }
}
