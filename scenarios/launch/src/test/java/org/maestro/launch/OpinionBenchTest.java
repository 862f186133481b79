package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.maestro.bench.BenchReport;
import org.maestro.bench.words.OpinionBench;
import org.maestro.bench.words.SaidLine;
import org.maestro.dialogue.Sayable;
import org.maestro.language.Language;

/** A second opinion is measured by what would be asked back for it. */
class OpinionBenchTest {
  private static final double QUARTER = 25;
  private static final Map<String, List<String>> PROPOSED =
      Map.of(
          "nuke the kitchen light", List.of("oh dear", "turn off the kitchen light"),
          "mosey over here", List.of("turn on the bedroom light"),
          "whereabouts is Tom", List.of("Tom is frobnicated"));

  private final SpokenEvening evening = new SpokenEvening();

  @Test
  void whatIsAskedBackIsCounted() {
    List<SaidLine> lines =
        SpokenEvening.text(UnderstandCommandTest.class, "colloquial.tsv")
            .lines()
            .filter(line -> !line.startsWith("#"))
            .map(SaidLine::of)
            .filter(line -> PROPOSED.containsKey(line.words()))
            .toList();
    List<SaidLine> all = new ArrayList<>(lines);
    all.add(SaidLine.of("it's pitch black in the hallway\tDave\tlivingroom"));
    BenchReport report =
        new OpinionBench(
                Language.of(evening.home(), "en"),
                Sayable.of(evening.home(), "en"),
                line -> evening.situation(evening.home(), SpokenEvening.lines().get(0)),
                (said, known) ->
                    PROPOSED.containsKey(said)
                        ? CompletableFuture.completedFuture(PROPOSED.get(said))
                        : CompletableFuture.failedFuture(new IOException("Nobody is there.")),
                told -> {})
            .run(all);

    assertThat(report.rows().subList(0, 5))
        .extracting(BenchReport.Row::value)
        .containsExactly(0.0, QUARTER, QUARTER, QUARTER, QUARTER);
  }
}
