package org.maestro.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.TextNode;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.Verdict;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A device that describes itself wrongly is told what is wrong, and so is who looks for it. */
class RefusedDescriptionTest {

  private static final String BELL =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {"b": "https://example.org/bells#"}],
       "id": "b:bell-1", "type": "maestro:Device",
       "offers": {"id": "b:ring", "type": "maestro:Task",
         "input": {"name": "who", "types": ["domain:Person"]}, "effect": "(called ?who)", "cost": "1"},
       "brings": {"id": "b:called", "type": "maestro:Predicate", "arguments": ["?p - Person"]}}
      """;

  /** JADE keeps what it knows of a platform for a second after its end, by its name. */
  private static final AtomicInteger PLATFORMS = new AtomicInteger();

  private final String site = "bells-" + PLATFORMS.incrementAndGet();
  private final Topics topics = new Topics(site);
  private final WireFormat wire = new WireFormat();
  private final BlockingQueue<Verdict> verdicts = new LinkedBlockingQueue<>();

  @Test
  void theDeviceIsToldAndMendsItself() throws IOException, InterruptedException {
    try (Stage stage = Stage.paced(SiteSettings.of(site, bob()).build());
        Transport bell = new PahoTransport(stage.broker(), "bell-1")) {
      joins(bell, BELL.replace("(called ?who)", "(calld ?whom)"));

      Verdict refusal = next();
      assertThat(refusal.member() + " " + refusal.boot()).isEqualTo("bell-1 b1");
      assertThat(refusal.accepted()).isFalse();
      assertThat(refusal.faults())
          .extracting(Verdict.Fault::subject, Verdict.Fault::problem, Verdict.Fault::cure)
          .contains(
              tuple("ring", "uses the unknown predicate calld", "write called, if that is meant"))
          .hasSize(2);
      assertThat(agents(stage))
          .containsPattern("bell-1 +refused")
          .contains("bell-1 is refused: bell-1: ring effect uses the unknown predicate calld");

      assertThat(told(stage, "goal", "(called Bob)"))
          .contains("uses the unknown predicate called")
          .contains("What bell-1 would bring is not known, as it is described wrongly");

      JsonNode row = new ObjectMapper().readTree(agents(stage, "--json")).path("agents");
      assertThat(row)
          .anySatisfy(
              one -> {
                assertThat(one.path("members")).containsExactly(TextNode.valueOf("bell-1"));
                assertThat(one.path("agent").isNull()).isTrue();
                assertThat(one.path("why").asText()).contains("unknown predicate calld");
              });

      tells(bell, BELL);
      assertThat(next().accepted()).isTrue();
      stage.await("the bell", () -> stage.platform().presentMembers().contains("bell-1"));
      assertThat(agents(stage)).doesNotContain("refused");
    }
  }

  @Test
  void whoDescribesItselfWronglyLaterIsNotUsedAnyMoreAndThatIsShown()
      throws IOException, InterruptedException {
    try (Stage stage = Stage.paced(SiteSettings.of(site, bob()).build());
        Transport bell = new PahoTransport(stage.broker(), "bell-1")) {
      joins(bell, BELL);
      stage.await("the bell", () -> stage.platform().presentMembers().contains("bell-1"));

      tells(bell, BELL.replace("(called ?who)", "(calld ?who)"));
      assertThat(next().accepted()).isFalse();
      stage.await("it is not used", () -> !stage.platform().presentMembers().contains("bell-1"));

      assertThat(agents(stage))
          .containsPattern("bell-1 +\\S+ +bell-1 +refused")
          .contains("bell-1 is refused: bell-1: ring effect uses the unknown predicate calld");
      MaestroAssertions.assertThat(stage.goal("(called Bob)"))
          .isNotReached()
          .tells("its description is refused: bell-1: ring effect uses the unknown predicate");

      tells(bell, BELL);
      assertThat(next().accepted()).isTrue();
      stage.await("the bell", () -> stage.platform().presentMembers().contains("bell-1"));
      assertThat(agents(stage)).doesNotContain("refused");
    }
  }

  private static Home bob() {
    return new HomeLoader().load(Shipped.text("/homes/bob.ttl").orElseThrow(), "bob.ttl");
  }

  private void tells(Transport bell, String description) {
    bell.publish(
        Publication.retained(topics.description("bell-1"), description.getBytes(UTF_8)),
        failure -> {});
  }

  private void joins(Transport bell, String description) throws InterruptedException {
    BlockingQueue<String> connected = new LinkedBlockingQueue<>();
    bell.subscribe(
        topics.verdicts("bell-1"),
        Transport.RetainedMessages.SEND,
        message -> verdicts.add(wire.decodeVerdict(message.payload())));
    bell.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            connected.add("now");
          }

          @Override
          public void lost(String reason) {}
        });
    assertThat(connected.poll(30, TimeUnit.SECONDS)).isNotNull();
    tells(bell, description);
    bell.publish(
        Publication.retained(
            topics.status("bell-1"),
            wire.encode(new MemberStatus("bell-1", MemberStatus.Phase.READY, "b1"))),
        failure -> {});
  }

  private Verdict next() throws InterruptedException {
    Verdict verdict = verdicts.poll(30, TimeUnit.SECONDS);
    assertThat(verdict).isNotNull();
    return verdict;
  }

  private static String agents(Stage stage, String... more)
      throws IOException, InterruptedException {
    return told(stage, "agents", more);
  }

  private static String told(Stage stage, String name, String... more)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of(name, "--main", "127.0.0.1:" + stage.platform().port()));
    command.addAll(List.of(more));
    try (JavaProcess asking = JavaProcess.start(Maestro.class.getName(), command)) {
      JavaProcess.Ended ended = asking.await(Duration.ofSeconds(60));
      return ended.output() + ended.errors();
    }
  }
}
