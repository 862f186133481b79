package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.lang.acl.ACLMessage;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.SayWords;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.deployment.Directory;
import org.maestro.dialogue.Utterance;
import org.maestro.junit.ClockKind;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.launch.JavaProcess;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.ThinkingPart;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.time.PacedClock;

/**
 * Language, memory and goals are agents, each in a container of its own (ADE, 3; A15): what is said
 * is understood in one, known in the second, and reached by the third. The central agent has no
 * part in it, until the third is killed.
 */
@Isolated("its time is wall time, which others beside it would take")
@MaestroTest(home = "rooms", scene = "rooms", clock = ClockKind.PACED, speed = 4)
class ThinkingPartsTest {
  private final List<SentMessage> mail = new CopyOnWriteArrayList<>();
  private final List<StoryEntry> story = new CopyOnWriteArrayList<>();
  private Stage stage;

  @BeforeEach
  void listen(Stage its) {
    stage = its;
    stage.platform().onMail(mail::add);
    stage.platform().onStory(story::add);
  }

  @Test
  void inThreeContainersOfOneProcess() throws Exception {
    Home home = home();
    try (PacedClock clock = new PacedClock(1);
        JoinedContainer will = join("will", clock);
        JoinedContainer ears = join("ears", clock)) {
      will.think("will", home, Set.of(ThinkingPart.GOALS), new OptimalPlanner());
      ears.think("ears", home, Set.of(ThinkingPart.LANGUAGE), new OptimalPlanner());
      isUnderstoodKnownAndReached();
    }
  }

  @Test
  @Tag("full")
  void inThreeProcesses(@TempDir Path directory) throws Exception {
    try (JavaProcess ears = process("ears", "language", directory);
        JavaProcess will = process("will", "goals", directory)) {
      until(() -> will.output().contains("and thinks: goals") || !will.isAlive());
      until(() -> ears.output().contains("and thinks: language") || !ears.isAlive());
      assertThat(will.isAlive()).as(will::errors).isTrue();
      assertThat(ears.isAlive()).as(ears::errors).isTrue();
      isUnderstoodKnownAndReached();

      will.kill();
      until(() -> replyTo("turn off the bathroom light").contains("(:goals G"));
      until(() -> stage.world().lampLevel("bath-lamp") == 0);
    }
  }

  private void isUnderstoodKnownAndReached() {
    until(() -> placeOf(AgentNames.GOALS).equals("will"));
    until(() -> placeOf(AgentNames.LANGUAGE).equals("ears"));
    assertThat(placeOf(AgentNames.KNOWLEDGE)).isEqualTo("Main-Container");
    until(() -> isSent("supervisor", "language", content -> content.contains("(:agent goals)")));
    until(() -> isSent("bath-lamp", "goals", content -> content.contains("ready")));
    until(() -> replyTo("is the bathroom light on").contains("No"));
    assertThat(isSent("language", "knowledge", content -> content.contains("level bath-lamp")))
        .isTrue();

    List<ACLMessage> replies = say("turn on the bathroom light");
    until(() -> replies.size() == 2 || reasonIn(replies));
    assertThat(replies.get(0).getPerformative())
        .as(replies.get(0).getContent())
        .isEqualTo(ACLMessage.AGREE);
    assertThat(replies.get(0).getContent())
        .contains("(:means \"(initCNP (:goal (= (level bath-lamp) 1)))\")")
        .contains("(:goals goals-1)");
    assertThat(replies.get(1).getContent()).contains("(:state achieved)");
    assertThat(stage.world().lampLevel("bath-lamp")).isEqualTo(1);
    until(() -> replyTo("is the bathroom light on").contains("Yes"));
    assertThat(story).as("of goals of the central agent or of rooms").isEmpty();
  }

  private static boolean reasonIn(List<ACLMessage> replies) {
    return replies.stream().anyMatch(reply -> reply.getContent().contains(":reason "));
  }

  private List<ACLMessage> say(String text) {
    List<ACLMessage> replies = new CopyOnWriteArrayList<>();
    stage
        .platform()
        .desk()
        .request(
            ACLMessage.REQUEST,
            AgentNames.LANGUAGE,
            Duration.ofMinutes(10),
            replies::add,
            SayWords.content(new Utterance("Dave", "bathroom", text, Optional.empty())));
    return replies;
  }

  /** The first answer, whatever it is. */
  private String replyTo(String text) {
    List<ACLMessage> replies = say(text);
    until(() -> !replies.isEmpty());
    return replies.get(0).getContent();
  }

  private boolean isSent(String from, String to, Predicate<String> content) {
    return mail.stream()
        .filter(message -> message.sender().startsWith(from + "@"))
        .filter(message -> message.receiver().startsWith(to + "@"))
        .anyMatch(message -> content.test(message.content()));
  }

  private String placeOf(String agent) {
    return stage.platform().directory().find(agent).map(Directory.Entry::container).orElse("");
  }

  private JoinedContainer join(String name, PacedClock clock) {
    return JoinedContainer.join(
        Optional.of(stage.platform().desk().getHap()),
        "127.0.0.1",
        stage.platform().port(),
        name + "-door",
        clock);
  }

  private JavaProcess process(String name, String part, Path directory) throws Exception {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of(
            "container",
            "--main",
            "127.0.0.1:" + stage.platform().port(),
            "--name",
            name,
            "--part",
            part,
            "--home",
            "rooms"),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static Home home() throws Exception {
    try (InputStream turtle = ThinkingPartsTest.class.getResourceAsStream("/homes/rooms.ttl")) {
      return new HomeLoader()
          .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "rooms.ttl");
    }
  }

  private static void until(BooleanSupplier condition) {
    await().atMost(Duration.ofSeconds(60)).until(condition::getAsBoolean);
  }
}
