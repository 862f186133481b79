package org.maestro.coordination.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.coordination.api.GoalState;

/** The table of a goal's phases. That goals keep to it is asserted wherever one changes. */
class GoalPhaseTest {
  private static final Path GUIDE = Path.of("../docs/goals.md");

  @Test
  void isTheOneOfTheGuide() throws IOException {
    List<String> rows =
        Files.readAllLines(GUIDE).stream().filter(line -> line.startsWith("| `")).toList();

    assertThat(rows)
        .containsExactlyElementsOf(Stream.of(GoalPhase.values()).map(this::row).toList());
  }

  private String row(GoalPhase phase) {
    return "| `%s` | %s | %s | %s |"
        .formatted(
            phase,
            phase.shown().map(GoalPhaseTest::word).orElse(""),
            phase.meaning(),
            phase.next().stream().map(next -> "`" + next + "`").collect(Collectors.joining(" ")));
  }

  private static String word(GoalState state) {
    return state.name().toLowerCase(Locale.ROOT);
  }

  @ParameterizedTest
  @EnumSource
  void eachIsComeToFromTheBeginningAndLeadsToAnEnd(GoalPhase phase) {
    assertThat(after(GoalPhase.SUBMITTED)).contains(phase);
    assertThat(after(phase)).anyMatch(end -> end.shown().filter(GoalState::isFinal).isPresent());
  }

  private static Set<GoalPhase> after(GoalPhase phase) {
    Set<GoalPhase> all = EnumSet.of(phase);
    boolean grows = true;
    while (grows) {
      grows =
          all.addAll(all.stream().flatMap(one -> one.next().stream()).collect(Collectors.toSet()));
    }
    return all;
  }

  @ParameterizedTest
  @EnumSource
  void anEndHasNothingAfterItAndAllElseMayEnd(GoalPhase phase) {
    boolean isEnd = phase.shown().filter(GoalState::isFinal).isPresent();

    assertThat(phase.next().isEmpty()).isEqualTo(isEnd);
    assertThat(phase.isOver() || phase.next().contains(GoalPhase.ENDING)).isTrue();
  }

  @ParameterizedTest
  @EnumSource(
      mode = EnumSource.Mode.EXCLUDE,
      names = {"ACHIEVED", "FAILED", "CANCELLED"})
  void anEndIsNoneThatIsNotFinal(GoalState state) {
    assertThatThrownBy(() -> GoalPhase.of(state)).hasMessageContaining("is no end");
  }
}
