package org.maestro.bench.words;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.bench.BenchReport;
import org.maestro.dialogue.Paraphraser;
import org.maestro.dialogue.Sayable;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Situation;
import org.maestro.sl.SlPrinter;

/**
 * What a second opinion is worth on utterances that are not understood: how often what it proposes
 * first is what was meant, how often it would be asked whether something else is, and how long one
 * waits for it. For one thread.
 */
public final class OpinionBench {
  private static final double PERCENT = 100;

  private final Language language;
  private final Sayable known;
  private final Function<SaidLine, Situation> situations;
  private final Paraphraser other;
  private final Consumer<String> progress;

  /**
   * @param known what the second one is told that can be said
   * @param situations where each utterance is said
   * @param other the one who is asked
   * @param progress told what becomes of each utterance
   */
  public OpinionBench(
      Language language,
      Sayable known,
      Function<SaidLine, Situation> situations,
      Paraphraser other,
      Consumer<String> progress) {
    this.language = language;
    this.known = known;
    this.situations = situations;
    this.other = other;
    this.progress = progress;
  }

  /** What became of an utterance. */
  private enum Fate {
    UNDERSTOOD("understood without it"),
    RIGHT("what was meant is asked back"),
    OTHER("something else is asked back"),
    NOTHING("nothing is proposed that is understood"),
    FAILED("it has not answered");

    private final String words;

    Fate(String words) {
      this.words = words;
    }
  }

  /**
   * The shares of all.
   *
   * @param lines what is said, with what it means
   */
  public BenchReport run(List<SaidLine> lines) {
    List<Fate> fates = new ArrayList<>();
    List<Double> seconds = new ArrayList<>();
    for (SaidLine line : lines) {
      fates.add(fate(line, seconds));
    }
    List<BenchReport.Row> rows = new ArrayList<>();
    for (Fate fate : Fate.values()) {
      double share = PERCENT * Collections.frequency(fates, fate) / lines.size();
      rows.add(BenchReport.Row.of(fate.words, share, "%"));
    }
    if (!seconds.isEmpty()) {
      Collections.sort(seconds);
      rows.add(BenchReport.Row.of("an answer, median", seconds.get(seconds.size() / 2), "s"));
      rows.add(BenchReport.Row.of("the slowest answer", seconds.get(seconds.size() - 1), "s"));
    }
    return new BenchReport("opinion", BenchReport.thisMachine(), rows);
  }

  private Fate fate(SaidLine line, List<Double> seconds) {
    Situation situation = situations.apply(line);
    Understanding own = language.understand(line.words(), situation);
    if (own.message().isPresent() || own.question().isPresent()) {
      return told(line, Fate.UNDERSTOOD, own.message().map(SlPrinter::print).orElse("asks"));
    }
    long begun = System.nanoTime();
    List<String> proposals;
    try {
      proposals = other.proposals(line.words(), known).join();
    } catch (CompletionException e) {
      return told(line, Fate.FAILED, String.valueOf(e.getCause()));
    }
    seconds.add((double) (System.nanoTime() - begun) / Duration.ofSeconds(1).toNanos());
    for (String proposal : proposals) {
      Optional<String> wish = wish(language.understand(proposal, situation));
      if (wish.isPresent()) {
        return told(line, wish.equals(line.means()) ? Fate.RIGHT : Fate.OTHER, proposal);
      }
    }
    return told(line, Fate.NOTHING, String.join(" | ", proposals));
  }

  /** As in a conversation: a sentence with a word that nobody knows proposes nothing. */
  private static Optional<String> wish(Understanding proposed) {
    return proposed.wish().filter(wish -> proposed.unknown().isEmpty()).map(SlPrinter::print);
  }

  private Fate told(SaidLine line, Fate fate, String what) {
    progress.accept("%s: %s: %s".formatted(line.words(), fate.words, what));
    return fate;
  }
}
