package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.pulse.Watcher;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.rats.time.PacedClock;

/** Signs of life between containers as JADE carries them, each under the key of its process. */
class PulseServiceTest {
  private static final Duration SOON = Duration.ofSeconds(30);

  @TempDir Path files;

  @Test
  void containersAreHeardUnderTheirOwnKeysAndAnAgentIsTakenOutByOrder() throws Exception {
    Queue<String> told = new ConcurrentLinkedQueue<>();
    try (BareJade jade = new BareJade("pulses", files);
        PacedClock clock = new PacedClock(1)) {
      AgentTime time = AgentTime.of(clock);
      DeskAgent centre = new DeskAgent(jade.birth(), time);
      BareJade.start(jade.main(), "centre", centre);
      var elsewhere = jade.join("elsewhere");
      DeskAgent lamp = new DeskAgent(Birth.of(elsewhere), time);
      BareJade.start(elsewhere, "lamp", lamp);
      Pulse pulse = centre.pulse().orElseThrow();
      pulse.watch(
          clock,
          HeartbeatSettings.standard(),
          new Watcher() {
            @Override
            public void container(String name, Condition now, Duration silence) {
              told.add(name + " " + now);
            }

            @Override
            public void agent(String agent, Condition now, Duration silence) {
              told.add(agent + " " + now);
            }
          });
      await()
          .atMost(SOON)
          .until(
              () ->
                  pulse
                      .signs()
                      .conditions()
                      .equals(
                          Map.of("elsewhere", Condition.ALIVE, "Main-Container", Condition.ALIVE)));
      assertThat(lamp.isCutOff()).isFalse();

      pulse.end("elsewhere", "lamp");

      await().atMost(SOON).until(lamp::isCutOff);
      assertThat(told).isEmpty();
    }
  }
}
