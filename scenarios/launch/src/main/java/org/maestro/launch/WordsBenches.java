package org.maestro.launch;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;
import org.maestro.bench.words.LanguageBench;
import org.maestro.bench.words.NoiseBench;
import org.maestro.bench.words.OpinionBench;
import org.maestro.bench.words.SaidLine;
import org.maestro.dialogue.Paraphraser;
import org.maestro.dialogue.Sayable;
import org.maestro.language.Language;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;

/** The benchmarks of words, in the evening's house at five past six. */
final class WordsBenches {
  private static final int MINUTE_OF_DAY = 18 * 60 + 5;
  private static final int THINGS = 1_000;
  private static final int TITLES = 10_000;
  private static final int TIMES = 5;
  private static final String ROBOT = "rob";

  private WordsBenches() {}

  /** How fast words are understood among many names. */
  static BenchReport language(int runs, Consumer<String> progress) {
    return new LanguageBench(
            Shipped.text("/homes/evening.ttl").orElseThrow(),
            home -> SceneFacts.of(home, Optional.of(Shipped.scene("evening", home))),
            THINGS,
            TITLES,
            TIMES * runs,
            progress)
        .run();
  }

  /** What becomes of the file's utterances with noise in them. */
  static BenchReport noise(Path file, int times, long seed, Consumer<String> progress) {
    List<SaidLine> lines = UnderstandCommand.lines(file).stream().map(SaidLine::of).toList();
    Home evening = Shipped.home("evening");
    Facts facts = SceneFacts.of(evening, Optional.of(Shipped.scene("evening", evening)));
    return new NoiseBench(
            Language.of(evening, "en"),
            line -> said(evening, facts, line.speaker(), line.room()),
            times,
            seed,
            progress)
        .run(lines);
  }

  /** What a second opinion is worth on the file's utterances. */
  static BenchReport opinion(Path file, Paraphraser other, Consumer<String> progress) {
    List<SaidLine> lines = UnderstandCommand.lines(file).stream().map(SaidLine::of).toList();
    Home evening = Shipped.home("evening");
    Facts facts = SceneFacts.of(evening, Optional.of(Shipped.scene("evening", evening)));
    return new OpinionBench(
            Language.of(evening, "en"),
            Sayable.of(evening, "en"),
            line -> said(evening, facts, line.speaker(), line.room()),
            other,
            progress)
        .run(lines);
  }

  private static Situation said(
      Home home, Facts facts, Optional<String> speaker, Optional<String> room) {
    return new Situation(
        home,
        facts,
        speaker,
        room,
        Optional.of(ROBOT),
        OptionalInt.of(MINUTE_OF_DAY),
        Discourse.NONE);
  }
}
