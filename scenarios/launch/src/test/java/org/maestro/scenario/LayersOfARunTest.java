package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.GoalReport;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.GoalState;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.maestro.scenario.LayerLog.Layer;
import org.maestro.scenario.LayerLog.Party;
import org.maestro.scenario.LayerLog.Talk;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;

/** Who talks with whom (Three-layered architecture, 3; M23), in a run and in principle. */
class LayersOfARunTest {
  private static final Duration LIMIT = Duration.ofMinutes(10);

  /** The client of the bus by which the agents of a platform reach the members. */
  private static final String CONTROLLER = "maestro";

  private static final String SITE = "layers";
  private static final Topics TOPICS = new Topics(SITE);

  /** All that agents and clients of the bus say while Bob's cup is fetched, and then a stranger. */
  @Test
  void inARunEachTalksWithinItsLayerOrToTheNextAndWhoSkipsOneIsFound() {
    try (LocalSite site = bob()) {
      LayerLog log = new LayerLog(TOPICS, site.home().devices().keySet(), Set.of(CONTROLLER));
      site.bus().disturb(log);
      Runnable end = site.platform().onMail(message -> log.sent(message, SITE));

      assertThat(fetched(site)).isEqualTo(GoalState.ACHIEVED);

      assertThat(log.faults()).isEmpty();
      assertThat(log.talks())
          .as("messages of agents")
          .anyMatch(talk -> talk.what().equals("cfp") && talk.from().name().equals("CCA@layers"))
          .as("calls")
          .anyMatch(
              talk ->
                  talk.isBetween(Layer.CONTROL, Layer.DOMAIN)
                      && talk.to().name().equals("rose")
                      && talk.what().equals(TOPICS.call(CONTROLLER)))
          .as("results")
          .anyMatch(
              talk ->
                  talk.isBetween(Layer.DOMAIN, Layer.CONTROL)
                      && talk.what().equals(TOPICS.result(CONTROLLER, "rose")))
          .as("states, which other members may hear")
          .anyMatch(
              talk ->
                  talk.isBetween(Layer.DOMAIN, Layer.DOMAIN)
                      && talk.what().equals(TOPICS.state("rose")));

      Transport gripper = site.bus().client("gripper-driver");
      AtomicReference<Boolean> sent = new AtomicReference<>(false);
      gripper.open(Optional.empty(), new Saying(gripper, sent));
      site.runUntil(sent::get, LIMIT);
      gripper.close();
      end.run();

      assertThat(sent).hasValue(true);
      assertThat(log.faults())
          .containsExactly(
              "gripper-driver must not tell maestro rats/1/layers/progress/maestro/gripper-driver.");
    }
  }

  @Test
  void noLayerIsSkippedAndHardwareHasNoNeighbours() {
    LayerLog log = new LayerLog(TOPICS, Set.of("rose", "lamp-b1"), Set.of(CONTROLLER));
    for (Layer from : Layer.values()) {
      for (Layer to : Layer.values()) {
        log.add(new Talk(Party.of("the " + from, from), Party.of("the " + to, to), "it"));
      }
    }
    assertThat(log.faults())
        .containsExactly(
            "the HARDWARE must not tell the HARDWARE it.",
            "the HARDWARE must not tell the CONTROL it.",
            "the CONTROL must not tell the HARDWARE it.");
  }

  @Test
  void whoSpeaksForAnotherAndWhoIsOfNoLayerIsFound() {
    LayerLog log = new LayerLog(TOPICS, Set.of("rose", "lamp-b1"), Set.of(CONTROLLER));
    log.published("rose", progress("lamp-b1"));
    log.sent(message("CCA@layers", "lamp-b1@layers"), SITE);
    log.sent(message("CCA@layers", "stranger@elsewhere"), SITE);
    assertThat(log.faults())
        .containsExactly(
            "rose speaks on rats/1/layers/progress/maestro/lamp-b1, which is not its own.",
            "CCA@layers must not tell stranger@elsewhere request.");
  }

  private static SentMessage message(String sender, String receiver) {
    return new SentMessage("request", sender, receiver, Optional.empty(), Optional.empty(), "");
  }

  private static Publication progress(String member) {
    return Publication.reliable(
        TOPICS.progress(CONTROLLER, member),
        new WireFormat().encode(new Progress("c1", member, Progress.Kind.STARTED, 0, Map.of())),
        Optional.empty());
  }

  /** Says something as soon as it may. */
  private record Saying(Transport transport, AtomicReference<Boolean> sent)
      implements Transport.ConnectionListener {
    @Override
    public void connected() {
      transport.publish(progress(transport.clientId()), failure -> sent.set(failure.isEmpty()));
    }

    @Override
    public void lost(String reason) {
      throw new AssertionError(reason);
    }
  }

  private static GoalState fetched(LocalSite site) {
    AtomicReference<Optional<GoalReport>> report = new AtomicReference<>(Optional.empty());
    site.platform()
        .desk()
        .pursue(
            SlParser.formula("(nextTo Cup Bob)"),
            id -> {},
            ended -> report.set(Optional.of(ended)));
    site.runUntil(() -> report.get().isPresent(), LIMIT);
    return report.get().orElseThrow().state();
  }

  private static LocalSite bob() {
    try (InputStream home = LayersOfARunTest.class.getResourceAsStream("/homes/bob.ttl");
        InputStream scene = LayersOfARunTest.class.getResourceAsStream("/scenes/bob-dark.ttl")) {
      Home loaded =
          new HomeLoader().load(new String(home.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
      return LocalSite.stepped(
          SiteSettings.of(SITE, loaded)
              .scene(SceneLoader.load("bob-dark.ttl", scene, loaded))
              .build());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
