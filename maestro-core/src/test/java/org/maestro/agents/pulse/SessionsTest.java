package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * What a main container and its processes believe of each other, where somebody between them hears,
 * repeats and says what he likes.
 */
class SessionsTest {
  private static final String BEAT = "life-1 - lights\n";

  private final Map<String, ProcessSession> processByContainer = new HashMap<>();
  private final List<String> log = new ArrayList<>();
  private final ProcessSession lights = new ProcessSession();
  private final ProcessSession robots = new ProcessSession();
  private final Sessions sessions = new Sessions(new Wires(), log::add);

  private final class Wires implements Sessions.Containers {
    @Override
    public void tell(String container, String request, String key) {
      Objects.requireNonNull(processByContainer.get(container)).begin(request, key);
    }

    @Override
    public String session(String container) {
      return Objects.requireNonNull(processByContainer.get(container)).name().orElse("");
    }
  }

  @BeforeEach
  void begin() {
    processByContainer.put("lights", lights);
    processByContainer.put("lamps", lights);
    processByContainer.put("robots", robots);
    sessions.begin("lights", lights.await());
    sessions.begin("robots", robots.await());
  }

  private String confirmed(ProcessSession process, String beat) {
    Sealed heard = sessions.heard(process.seal(beat));
    assertThat(heard.text()).isEqualTo(beat);
    return process.confirmed(sessions.confirm(heard, "500 3500"));
  }

  @Test
  void whatIsSealedIsHeardAndConfirmed() {
    assertThat(confirmed(lights, BEAT)).isEqualTo("500 3500");
    assertThat(confirmed(robots, BEAT)).isEqualTo("500 3500");
    assertThat(confirmed(lights, BEAT)).isEqualTo("500 3500");
    assertThat(log).isEmpty();
  }

  @Test
  void aSignOfLifeThatWasHeardBeforeIsRefusedAndLogged() {
    String first = lights.seal(BEAT);
    sessions.heard(first);
    assertRefused(first, "it has come before");
    String second = lights.seal(BEAT);
    sessions.heard(second);
    assertRefused(first, "it has come before");
    assertRefused(second, "it has come before");
    assertThat(log).hasSize(3);
  }

  @Test
  void aSignOfLifeThatSomebodyElseHasMadeIsRefusedAndLogged() {
    Sealed real = Sealed.read(lights.seal(BEAT));
    for (Sealed forged :
        List.of(
            new Sealed(real.session(), real.number() + 1, real.seal(), real.text()),
            new Sealed(real.session(), real.number(), real.seal(), "life-2 - lights\n"),
            new Sealed(real.session(), real.number(), "", real.text()),
            new Sealed(
                real.session(), real.number(), Sealed.read(robots.seal(BEAT)).seal(), real.text()),
            SessionKey.read(real.session() + " " + "00".repeat(32))
                .seal(SessionKey.Kind.BEAT, 9, BEAT))) {
      assertRefused(forged.write(), "it is not under the seal of its session");
    }
    assertThat(log).hasSize(5);
    assertThat(sessions.heard(real.write()).text()).isEqualTo(BEAT);
  }

  private void assertRefused(String written, String why) {
    assertThatThrownBy(() -> sessions.heard(written))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(why);
    assertThat(log).last().asString().contains("A sign of life was refused", why);
  }

  @Test
  void whatIsNotSealedOrOfNoSessionIsNotHeard() {
    String ofAnother = SessionKey.fresh().seal(SessionKey.Kind.BEAT, 1, BEAT).write();
    for (String written : List.of(BEAT, "", "x y z\n", "a 1 b", ofAnother)) {
      assertThatThrownBy(() -> sessions.heard(written))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }

  /** A process that was let in says that another one lives. */
  @Test
  void nobodySpeaksForTheContainersOfAnotherProcess() {
    Sealed beat = sessions.heard(robots.seal(BEAT));
    List<Beat.Living> said =
        List.of(
            new Beat.Living("robots", "life-2", List.of()),
            new Beat.Living("lights", "life-1", List.of()));
    assertThat(sessions.own(beat, said)).extracting(Beat.Living::name).containsExactly("robots");
    assertThat(log)
        .containsExactly(
            "A sign of life of the container lights was refused: its process has another session.");
    Sealed own = sessions.heard(lights.seal(BEAT));
    assertThat(
            sessions.own(
                own,
                List.of(
                    new Beat.Living("lights", "life-1", List.of()),
                    new Beat.Living("lamps", "life-3", List.of()))))
        .hasSize(2);
  }

  @Test
  void aConfirmationIsThatOfTheLatestSignOfLifeAndTheMainContainers() {
    Sealed first = sessions.heard(lights.seal(BEAT));
    String early = sessions.confirm(first, "500 3500");
    Sealed second = sessions.heard(lights.seal(BEAT));
    String ofAnother = sessions.confirm(sessions.heard(robots.seal(BEAT)), "500 9999999");
    Sealed right = Sealed.read(sessions.confirm(second, "500 3500"));
    for (String answer :
        List.of(
            early,
            ofAnother,
            "500 9999999",
            second.write(),
            new Sealed(right.session(), right.number(), right.seal(), "500 9999999").write())) {
      assertThatThrownBy(() -> lights.confirmed(answer))
          .isInstanceOf(IllegalArgumentException.class);
    }
    assertThat(lights.confirmed(right.write())).isEqualTo("500 3500");
  }

  /** What only the registry may order wants its key (ADE, 3.1; A23). */
  @Test
  void anOrderIsTheMainContainersAndObeyedOnce() {
    String order = sessions.order("lights", "lamp-1");
    Sealed beat = Sealed.read(lights.seal("lamp-1"));
    for (String forged :
        List.of(
            "lamp-1",
            beat.write(),
            sessions.order("robots", "lamp-1"),
            SessionKey.fresh().seal(SessionKey.Kind.ORDER, 1, "lamp-1").write())) {
      assertThatThrownBy(() -> lights.ordered(forged)).isInstanceOf(IllegalArgumentException.class);
    }
    String next = sessions.order("lights", "lamp-2");
    assertThat(lights.ordered(next)).isEqualTo("lamp-2");
    assertThat(lights.ordered(order)).isEqualTo("lamp-1");
    for (String again : List.of(order, next)) {
      assertThatThrownBy(() -> lights.ordered(again))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("has come before");
    }
    assertThatThrownBy(() -> sessions.order("nowhere", "lamp-1"))
        .isInstanceOf(IllegalStateException.class);
  }

  @Test
  void aKeyThatNobodyAskedForIsNotTaken() {
    String name = lights.name().orElseThrow();
    String key = SessionKey.fresh().write();
    assertThatThrownBy(() -> lights.begin("guessed", key))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("nobody has asked for");
    String request = lights.await();
    assertThatThrownBy(() -> sessions.begin("robots", request))
        .isInstanceOf(IllegalArgumentException.class);
    sessions.begin("lights", request);
    assertThatThrownBy(() -> lights.begin(request, key))
        .isInstanceOf(IllegalArgumentException.class);
    assertThat(lights.name()).isPresent().isNotEqualTo(Optional.of(name));
    assertThat(confirmed(lights, BEAT)).isEqualTo("500 3500");
  }
}
