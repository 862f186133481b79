package org.maestro.bench.words;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.maestro.bench.BenchReport;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.Understanding;
import org.maestro.language.hearing.Heard;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.lexicon.Tokens;
import org.maestro.language.reference.Situation;
import org.maestro.sl.SlPrinter;

/**
 * What becomes of utterances when words are lost, exchanged and misheard: how many are understood
 * all the same, how many are asked back or not understood, and how many are taken for something
 * else without a question (the rate, and what of it the heard words say themselves). For
 * one thread.
 */
public final class NoiseBench {
  /** Of how many words something happens to each; per cent. */
  public static final List<Integer> SHARES = List.of(5, 10, 20);

  private static final double PERCENT = 100;
  private static final int FIGURES = 100;

  private final Language language;
  private final Function<SaidLine, Situation> situations;
  private final int times;
  private final long seed;
  private final Consumer<String> progress;

  /**
   * @param situations where each utterance is said, before anything was
   * @param times how often each utterance is said, with other noise
   * @param progress told each utterance that was taken for something else
   */
  public NoiseBench(
      Language language,
      Function<SaidLine, Situation> situations,
      int times,
      long seed,
      Consumer<String> progress) {
    this.language = language;
    this.situations = situations;
    this.times = times;
    this.seed = seed;
    this.progress = progress;
  }

  /**
   * What became of utterances.
   *
   * @param share of how many words something happened to each; per cent
   * @param noisy of how many utterances other words were heard than said
   * @param right how many were understood, or answered, as without noise
   * @param asked how many were asked back or not understood
   * @param guessed how many were taken for something else because a word was taken for another,
   *     left out or taken back
   * @param plain how many were taken for something else that the heard words say by themselves
   */
  public record Rates(
      int share, int said, int noisy, int right, int asked, int guessed, int plain) {
    /** How many were taken for something else without a question. */
    public int wrong() {
      return guessed + plain;
    }

    private BenchReport.Row row(String what, int count) {
      return BenchReport.Row.of(
          String.format(Locale.ROOT, "%d %% of words: %s", share, what),
          PERCENT * count / said,
          "%");
    }

    List<BenchReport.Row> rows() {
      return List.of(
          row("utterances with noise", noisy),
          row("right", right),
          row("asked back or not understood", asked),
          row("wrong without a question", wrong()),
          row("  of these, as the heard words say themselves", plain));
    }
  }

  /** The rates at each share. */
  public BenchReport run(List<SaidLine> lines) {
    return new BenchReport(
        "noise",
        BenchReport.thisMachine(),
        SHARES.stream().flatMap(share -> rates(lines, share).rows().stream()).toList());
  }

  /** What becomes of the utterances. */
  public Rates rates(List<SaidLine> lines, int share) {
    Noise noise = new Noise(new SoundsAlike(heardWords()), seed);
    int noisy = 0;
    int right = 0;
    int asked = 0;
    int guessed = 0;
    int plain = 0;
    for (SaidLine line : lines) {
      Situation situation = after(line);
      List<String> words = language.words(line.words());
      Understanding clean = understood(words, situation);
      String meant = line.means().orElseGet(() -> meaning(clean));
      for (int time = 0; time < times; time++) {
        List<String> heard = noise.of(words, share / PERCENT);
        Understanding understanding = heard.equals(words) ? clean : understood(heard, situation);
        noisy += heard.equals(words) ? 0 : 1;
        if (meaning(understanding).equals(meant)) {
          right++;
        } else if (understanding.message().isEmpty()) {
          asked++;
        } else {
          boolean isPlain = isPlain(understanding, clean);
          plain += isPlain ? 1 : 0;
          guessed += isPlain ? 0 : 1;
          progress.accept(told(share, isPlain, words, heard, understanding));
        }
      }
    }
    return new Rates(share, lines.size() * times, noisy, right, asked, guessed, plain);
  }

  private static String told(
      int share,
      boolean isPlain,
      List<String> words,
      List<String> heard,
      Understanding understanding) {
    return "%d %%%s: %s | %s | %s"
        .formatted(
            share,
            isPlain ? "" : ", guessed",
            String.join(" ", words),
            String.join(" ", heard),
            meaning(understanding));
  }

  private Situation after(SaidLine line) {
    Situation situation = situations.apply(line);
    return line.before()
        .map(before -> language.understand(before, situation))
        .map(before -> situation.after(before.discourse(situation.discourse())))
        .orElse(situation);
  }

  private Understanding understood(List<String> words, Situation situation) {
    Listening listening = language.listen(situation);
    words.forEach(listening::hear);
    return listening.end(String.join(" ", words));
  }

  /** Whether no word is left out, taken back or taken for another that was not without noise. */
  private static boolean isPlain(Understanding noisy, Understanding clean) {
    return notTaken(clean).containsAll(notTaken(noisy));
  }

  private static Set<String> notTaken(Understanding understanding) {
    Set<String> words = new HashSet<>();
    understanding.heard().stream()
        .filter(word -> word.fate() != Heard.Fate.TAKEN)
        .forEach(word -> words.add(word.fate() + " " + word.word()));
    return words;
  }

  private static String meaning(Understanding understanding) {
    return understanding
        .message()
        .map(SlPrinter::print)
        .orElseGet(() -> "- " + understanding.question().or(understanding::reply).orElse(""));
  }

  /** All words of the home and its language, figures, and common ones that are neither. */
  private Set<String> heardWords() {
    Set<String> words = new HashSet<>(language.lexicon().words());
    words.addAll(HeardWords.wordsOf(language.grammar()));
    language.grammar().lists().values().forEach(list -> list.forEach(words::addAll));
    words.addAll(List.of(WordFiles.text("common.txt").strip().split("\\s+")));
    IntStream.range(0, FIGURES).mapToObj(Integer::toString).forEach(words::add);
    words.remove(Tokens.CUT_OFF);
    return words;
  }
}
