package org.maestro.bench.words;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.bench.BenchReport;
import org.maestro.bench.Quantile;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;

/**
 * How fast words are understood in a home with many things and titles, how early and how steadily;
 * and whole sentences beside an engine that matches them with templates. For one thread.
 */
public final class LanguageBench {
  private static final double NANOS_PER_MILLI = 1e6;
  private static final double MEDIAN = 0.5;
  private static final double LAST_PERCENT = 0.99;
  private static final double DEMANDED_MEDIAN = 0.2;
  private static final double DEMANDED_LAST = 5;
  private static final double DEMANDED_OVERHEAD = 0.2;
  private static final double DEMANDED_INDEX = 1;
  private static final double PERCENT = 100;
  private static final int MINUTE_OF_DAY = 18 * 60 + 5;
  private static final int SLOWEST = 5;

  private final String evening;
  private final Function<Home, Facts> facts;
  private final ManyNames names;
  private final int times;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();
  private final List<String> summary = new ArrayList<>();

  /**
   * @param evening the text of the evening's home
   * @param facts what is so in a home
   * @param things how many more things it has
   * @param titles how many more titles
   * @param times how often each utterance is measured, after as often to warm up
   * @param progress told what is being done
   */
  public LanguageBench(
      String evening,
      Function<Home, Facts> facts,
      int things,
      int titles,
      int times,
      Consumer<String> progress) {
    this.evening = evening;
    this.facts = facts;
    this.names = new ManyNames(things, titles);
    this.times = times;
    this.progress = progress;
  }

  public BenchReport run() {
    progress.accept(
        "Loading a home with %d more things and %d more titles."
            .formatted(names.things().size(), names.titles().size()));
    Home home = names.in(evening);
    long begun = System.nanoTime();
    Language language = Language.of(home, "en");
    double index = (System.nanoTime() - begun) / NANOS_PER_MILLI;
    Facts known = facts.apply(home);
    List<SaidLine> said = WordFiles.lines("said.tsv").stream().map(SaidLine::of).toList();
    progress.accept("Listening to %d utterances.".formatted(said.size()));
    words(language, home, known, said);
    increments(language, home, known, said);
    rows.add(
        demanding(
            "index of the lexicon, an individual (its first time)",
            index / home.individuals().size(),
            "ms",
            DEMANDED_INDEX));
    wholeSentences(language, home, known);
    return new BenchReport("language", BenchReport.thisMachine(), rows, summary);
  }

  private static Situation situation(Home home, Facts known, SaidLine line) {
    return new Situation(
        home,
        known,
        line.speaker(),
        line.room(),
        Optional.of("rob"),
        OptionalInt.of(MINUTE_OF_DAY),
        Discourse.NONE);
  }

  private static BenchReport.Row demanding(
      String name, double value, String unit, double demanded) {
    return new BenchReport.Row(
        String.format(Locale.ROOT, "%s (demanded: %.1f)", name, demanded),
        value,
        unit,
        OptionalDouble.of(demanded));
  }

  /**
   * How long one word of an utterance took.
   *
   * @param onCore what this thread had of a core meanwhile: others' load is left out; ms
   */
  private record Word(String of, String word, double millis, double onCore) {}

  private void words(Language language, Home home, Facts known, List<SaidLine> said) {
    List<Word> heard = new ArrayList<>();
    List<Double> ends = new ArrayList<>();
    for (int time = 0; time < 2 * times; time++) {
      if (time == times) {
        heard.clear();
        ends.clear();
      }
      for (SaidLine line : said) {
        ends.add(timed(language, situation(home, known, line), line.words(), heard));
      }
    }
    List<Double> millis = heard.stream().map(Word::millis).toList();
    rows.add(demanding("a word, median", Quantile.of(millis, MEDIAN), "ms", DEMANDED_MEDIAN));
    rows.add(
        demanding("a word, 99 of 100", Quantile.of(millis, LAST_PERCENT), "ms", DEMANDED_LAST));
    rows.add(
        BenchReport.Row.of(
            "  of a core, 99 of 100",
            Quantile.of(heard.stream().map(Word::onCore).toList(), LAST_PERCENT),
            "ms"));
    rows.add(BenchReport.Row.of("the end, 99 of 100", Quantile.of(ends, LAST_PERCENT), "ms"));
    Map<String, Word> slowest = new LinkedHashMap<>();
    heard.forEach(
        word ->
            slowest.merge(
                word.of(), word, (one, other) -> one.onCore() < other.onCore() ? other : one));
    slowest.values().stream()
        .sorted((one, other) -> Double.compare(other.onCore(), one.onCore()))
        .limit(SLOWEST)
        .forEach(
            word ->
                summary.add(
                    String.format(
                        Locale.ROOT,
                        "slow: \"%s\" in \"%s\", %.1f ms of a core",
                        word.word(),
                        word.of(),
                        word.onCore())));
  }

  /** Listens word by word; returns how long the end took, in ms. */
  private static double timed(
      Language language, Situation situation, String utterance, List<Word> heard) {
    Listening listening = language.listen(situation);
    for (String word : language.words(utterance)) {
      long begun = System.nanoTime();
      long begunOnCore = coreNanos();
      listening.hear(word);
      double onCore = (coreNanos() - begunOnCore) / NANOS_PER_MILLI;
      double millis = (System.nanoTime() - begun) / NANOS_PER_MILLI;
      heard.add(new Word(utterance, word, millis, onCore));
    }
    long begun = System.nanoTime();
    listening.end(utterance);
    return (System.nanoTime() - begun) / NANOS_PER_MILLI;
  }

  private static long coreNanos() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private void increments(Language language, Home home, Facts known, List<SaidLine> said) {
    Increments increments = new Increments();
    said.forEach(
        line ->
            increments.hear(language, language.words(line.words()), situation(home, known, line)));
    increments
        .firstCorrect()
        .ifPresent(
            share ->
                rows.add(BenchReport.Row.of("first correct, of the words", share * PERCENT, "%")));
    increments
        .firstFinal()
        .ifPresent(
            share ->
                rows.add(BenchReport.Row.of("first final, of the words", share * PERCENT, "%")));
    increments
        .editOverhead()
        .ifPresent(share -> rows.add(demanding("edit overhead", share, "", DEMANDED_OVERHEAD)));
  }

  private void wholeSentences(Language language, Home home, Facts known) {
    List<String> sentences = WordFiles.lines("whole.txt");
    progress.accept("Understanding %d whole sentences.".formatted(sentences.size()));
    SaidLine where = SaidLine.of("\tDave\tlivingroom");
    List<Double> millis = new ArrayList<>();
    int understood = 0;
    int asked = 0;
    for (int time = 0; time < 2 * times; time++) {
      for (String sentence : sentences) {
        long begun = System.nanoTime();
        Understanding understanding = language.understand(sentence, situation(home, known, where));
        if (time >= times) {
          millis.add((System.nanoTime() - begun) / NANOS_PER_MILLI);
        }
        understood += time == 0 && understanding.message().isPresent() ? 1 : 0;
        asked += time == 0 && understanding.question().isPresent() ? 1 : 0;
      }
    }
    Optional<PatternEngine.Found> other = PatternEngine.match(sentences, names, times);
    rows.add(
        beside(
            "whole sentences understood",
            PERCENT * understood / sentences.size(),
            "%",
            other.map(found -> PERCENT * found.matched() / sentences.size())));
    rows.add(
        BenchReport.Row.of("whole sentences asked back", PERCENT * asked / sentences.size(), "%"));
    rows.add(
        beside(
            "a whole sentence, median",
            Quantile.of(millis, MEDIAN),
            "ms",
            other.map(found -> Quantile.of(found.millis(), MEDIAN))));
    rows.add(
        beside(
            "a whole sentence, 99 of 100",
            Quantile.of(millis, LAST_PERCENT),
            "ms",
            other.map(found -> Quantile.of(found.millis(), LAST_PERCENT))));
    if (other.isEmpty()) {
      summary.add("hassil is not installed for python3: whole sentences have nothing beside them.");
    }
  }

  private static BenchReport.Row beside(
      String name, double value, String unit, Optional<Double> other) {
    return new BenchReport.Row(
        name, value, unit, other.map(OptionalDouble::of).orElseGet(OptionalDouble::empty));
  }
}
