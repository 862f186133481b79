package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.page.Page;

/** An experiment that is stopped shows what the runs show that are over, and says that it does. */
class CourseTest {

  static Stream<String> names() {
    return Experiments.all().stream().map(Experiment::name);
  }

  @ParameterizedTest
  @MethodSource("names")
  void theFirstRunOfEachExperimentIsWorthAPage(String name) throws IOException {
    Experiment experiment = Experiments.named(name).orElseThrow();
    Course<?> course =
        experiment.begin(
            new Request(2, 1, Experiments.settings(experiment, Map.of()).settings(), false));
    course.carryOut((done, of, line) -> course.stop());

    assertThat(course.done()).isEqualTo(1);
    Findings findings = course.findings();
    CarriedOut.assertReadable(findings);
    assertThat(findings.page().html())
        .contains("<strong>Interrupted after 1 of %d runs".formatted(course.runs()));
    assertThat(findings.results()).isNotEmpty();
  }

  @Test
  void aRunThatEndsAfterItWasStoppedDoesNotCount() {
    List<Integer> begun = new ArrayList<>();
    List<List<Integer>> shown = new ArrayList<>();
    List<Course<Integer>> own = new ArrayList<>();
    Course<Integer> course =
        new Course<>(
            4,
            run -> {
              begun.add(run);
              if (run == 3) {
                own.get(0).stop();
              }
              return run;
            },
            run -> "run " + run,
            runs -> {
              shown.add(runs);
              return findings();
            });
    own.add(course);
    assertThatThrownBy(course::findings).isInstanceOf(IllegalStateException.class);

    List<String> told = new ArrayList<>();
    course.carryOut((done, of, line) -> told.add(done + " of " + of + ": " + line));

    assertThat(begun).containsExactly(1, 2, 3);
    assertThat(told).containsExactly("1 of 4: run 1", "2 of 4: run 2");
    assertThat(course.findings().page().html()).contains("Interrupted after 2 of 4 runs");
    assertThat(shown).containsExactly(List.of(1, 2));
  }

  @Test
  void ofAllRunsNothingIsSaidToBeMissing() {
    Course<Integer> course = new Course<>(2, run -> run, run -> "", runs -> findings());
    course.carryOut((done, of, line) -> {});

    assertThat(course.done()).isEqualTo(2);
    assertThat(course.findings().page().html()).doesNotContain("Interrupted");
  }

  private static Findings findings() {
    return new Findings(
        "counting",
        List.of(),
        Map.of("runs", new Table("run")),
        List.<Figure>of(),
        new Page("Counting", "Runs are counted.", "./maestro experiment counting"));
  }
}
