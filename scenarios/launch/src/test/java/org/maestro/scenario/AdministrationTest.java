package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.maestro.junit.MaestroAssertions.assertThat;

import jade.core.AID;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.lang.acl.ACLMessage;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.deployment.Directory;
import org.maestro.junit.ClockKind;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.launch.JavaProcess;
import org.maestro.platform.AgentRow;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;

/**
 * Agents are added, moved, configured and removed while the platform runs, by requests of an agent
 * that knows JADE only (Three-layered architecture, 2, 3.3.1 and 3.3.3; M3, M65-M73).
 */
@Isolated("its time is wall time, which others beside it would take")
@MaestroTest(home = "bob", scene = "bob-dark", clock = ClockKind.PACED, speed = 10)
class AdministrationTest {
  private static final String WISH = "(nextTo Cup Bob)";

  private static final String GLIMMERS =
      """
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix : <https://example.org/wonders#> .
      :glimmer-1 a maestro:Device ; maestro:container "wonders" ; maestro:pose "5 1 2.5" ;
        maestro:offers :shimmer .
      :glimmer-2 a maestro:Device ; maestro:pose "1 1 2.5" ; maestro:offers :shimmer .
      :glimmer-3 a maestro:Device ; maestro:pose "1 2 2.5" ; maestro:offers :shimmer .
      :glimmer-4 a maestro:Device ; maestro:pose "1 3 2.5" ; maestro:offers :shimmer .
      :glimmer-5 a maestro:Device ; maestro:pose "2 1 2.5" ; maestro:offers :shimmer .
      :glimmer-6 a maestro:Device ; maestro:pose "2 2 2.5" ; maestro:offers :shimmer .
      :shimmer a maestro:Action ; maestro:sentence "{self} shimmers in {zone}" ;
        maestro:binds [ maestro:name "zone" ; maestro:type maestro:Zone ] ;
        maestro:precondition "(inside ?self ?zone)" ;
        maestro:effect "(increase (illuminance ?zone) 80)" ;
        maestro:cost "0.2" ; maestro:seconds "0.2" .
      """;

  private static final List<String> SIX =
      IntStream.rangeClosed(1, 6).mapToObj(number -> "glimmer-" + number).toList();

  private PlainAgent.Guest guest;

  @BeforeEach
  void aStrangerJoins(Stage stage) throws Exception {
    guest =
        PlainAgent.join(
            Optional.of(stage.platform().desk().getHap()),
            stage.platform().port(),
            "guests",
            "Guest");
  }

  @AfterEach
  void theStrangerLeaves() throws Exception {
    guest.close();
  }

  @Test
  void oneAgentStandsForSixLampsThatAFileDescribesUntilItIsRemoved(Stage stage) throws Exception {
    List<Directory.Entry> others = agentsOfDevices(stage);

    ACLMessage added = ask(add("glimmers", GLIMMERS));

    assertThat(added.getPerformative()).as(added.getContent()).isEqualTo(ACLMessage.INFORM);
    assertThat(added.getContent())
        .contains(
            "The agent glimmers lives in wonders, and stands for " + String.join(", ", SIX) + ".");
    assertThat(row(stage, "glimmers").members()).containsExactlyElementsOf(SIX);
    assertThat(row(stage, "glimmers").phase()).isEqualTo("absent");

    SIX.forEach(id -> glimmers(stage, id));
    stage.await("all are there", () -> stage.platform().presentMembers().containsAll(SIX));

    assertThat(stage.goal(WISH)).isReached().tells("glimmer-1 shimmers in zone-b");
    assertThat(agentsOfDevices(stage)).as("no other agent has noticed").containsAll(others);

    ACLMessage again = ask(add("glimmers", GLIMMERS));
    assertThat(again.getPerformative()).isEqualTo(ACLMessage.REFUSE);
    assertThat(again.getContent()).contains("There is an agent glimmers already, in wonders");

    ACLMessage removed = ask("(perform (:action remove) (:agent glimmers))");
    assertThat(removed.getContent()).contains("The agent glimmers is removed.");
    stage.await(
        "they are not counted on", () -> !stage.platform().presentMembers().contains("glimmer-1"));
    assertThat(stage.platform().agents()).extracting(AgentRow::agent).doesNotContain("glimmers");
    assertThat(stage.platform().directory().find("glimmers")).isEmpty();
  }

  @Test
  void aStrangerFindsACameraInTheYellowPagesAndHasAPersonLocated(Stage stage) throws Exception {
    List<DFAgentDescription> cameras = guest.agent().whoOffers("observeObject");
    assertThat(cameras)
        .extracting(camera -> camera.getName().getLocalName())
        .containsExactlyInAnyOrder("cam-a", "cam-b");
    assertThat(PlainAgent.property(cameras.get(0), "observeObject", "request"))
        .isEqualTo("(perform (:feature observeObject) (:parameters (:object Thing) (:zone Zone)))");

    guest
        .agent()
        .say(
            request(
                "cam-a",
                "(perform (:feature observeObject) (:parameters (:object Bob) (:zone zone-a)))"));
    ACLMessage agreed = guest.agent().heard();
    assertThat(agreed.getPerformative()).as(agreed.getContent()).isEqualTo(ACLMessage.AGREE);
    ACLMessage located = guest.agent().heard();
    assertThat(located.getPerformative()).as(located.getContent()).isEqualTo(ACLMessage.INFORM);
    assertThat(located.getContent())
        .startsWith("(inform (:outputs ")
        .contains("(:found true)")
        .containsPattern("\\(:pose \"0\\.7\\d* 2\\.\\d+");

    assertRefused("cam-a", "(perform (:feature fly))", "cam-a has no feature fly");
    assertRefused(
        "cam-a",
        "(perform (:feature observeObject) (:parameters (:object Bop) (:zone zone-a)))",
        "Nothing named Bop is known for the parameter object");
    assertThat(guest.agent().whoOffers("fly")).isEmpty();
  }

  @Test
  void theYellowPagesTellOfMoreThanAHundredAgents() throws Exception {
    for (int number = 0; number < 120; number++) {
      ACLMessage entered = guest.agent().enter("gossip-" + number, "gossip");
      assertThat(entered.getPerformative()).isEqualTo(ACLMessage.INFORM);
    }

    assertThat(guest.agent().whoOffers("gossip")).hasSize(120);
  }

  @Test
  void anAgentMovesToAnEmptyContainerOfAnotherProcessWhileItsGoalIsPursued(
      Stage stage, @TempDir Path directory) throws Exception {
    try (JavaProcess kitchen = container(stage, directory)) {
      stage.await(
          "the container is there",
          () -> kitchen.output().contains("The container kitchen runs here, empty"));
      assertThat(stage.platform().directory().agentsIn("kitchen")).isEmpty();

      Pursuit wish = stage.begin(WISH);
      stage.await("rose is busy", () -> !row(stage, "rose").state().equals("standby"));
      ACLMessage moved = ask("(perform (:action move) (:agent rose) (:to kitchen))");

      assertThat(moved.getContent()).contains("The agent rose lives in kitchen now.");
      assertThat(guest.agent().whereIs("rose")).contains(":name kitchen ");
      assertThat(stage.platform().directory().agentsIn("kitchen"))
          .extracting(Directory.Entry::agent)
          .containsExactly("rose");
      assertThat(stage.platform().directory().agentsIn("robots")).isEmpty();
      assertThat(wish.await()).isReached().neverTells("lost its agent").neverTells("failed");
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
      assertThat(offering("place")).containsExactly("rose");

      ACLMessage nowhere = ask("(perform (:action move) (:agent rose) (:to cellar))");
      assertThat(nowhere.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(nowhere.getContent()).contains("There is no container cellar; there are ");
    }
    stage.await("rose is back", () -> row(stage, "rose").container().equals("robots"));
    await().atMost(Duration.ofSeconds(30)).until(() -> offering("place").contains("rose"));
  }

  private void assertRefused(String agent, String content, String reason) throws Exception {
    guest.agent().say(request(agent, content));
    ACLMessage refused = guest.agent().heard();
    assertThat(refused.getPerformative()).as(refused.getContent()).isEqualTo(ACLMessage.REFUSE);
    assertThat(refused.getContent()).contains(reason);
  }

  private List<String> offering(String feature) throws Exception {
    return guest.agent().whoOffers(feature).stream()
        .map(entry -> entry.getName().getLocalName())
        .toList();
  }

  /** Asks the CCA for something about agents; the last answer. */
  private ACLMessage ask(String content) throws InterruptedException {
    guest.agent().say(request("CCA", content));
    return guest.agent().heard();
  }

  private static String add(String name, String description) {
    return "(perform (:action add) (:as %s) (:description \"%s\"))"
        .formatted(name, description.replace("\\", "\\\\").replace("\"", "\\\""));
  }

  private ACLMessage request(String agent, String content) {
    ACLMessage request = new ACLMessage(ACLMessage.REQUEST);
    request.addReceiver(new AID(agent + "@" + guest.agent().getHap(), AID.ISGUID));
    request.setOntology("WorldModel");
    request.setLanguage("MAESTRO-SL");
    request.setProtocol("fipa-request");
    request.setContent(content);
    return request;
  }

  private static AgentRow row(Stage stage, String agent) {
    return stage.platform().agents().stream()
        .filter(row -> row.agent().equals(agent))
        .findFirst()
        .orElseThrow();
  }

  private static List<Directory.Entry> agentsOfDevices(Stage stage) {
    List<String> containers = Arrays.asList("cameras", "lights", "robots", "sensors");
    return stage.platform().directory().agents().stream()
        .filter(entry -> containers.contains(entry.container()))
        .toList();
  }

  private static void glimmers(Stage stage, String id) {
    MemberProfile.Feature shimmer =
        new MemberProfile.Feature(
            "shimmer", Set.of(), Set.of(), false, Optional.empty(), "busy", shining(stage));
    stage.join(
        new MemberProfile(
            id,
            "{\"id\": \"https://example.org/wonders#" + id + "\"}",
            Set.of("calm", "busy"),
            "calm",
            Set.of("calm"),
            Map.of("shimmer", shimmer)),
        List::of);
  }

  private static Procedure shining(Stage stage) {
    return new Procedure() {
      @Override
      public void start(Execution execution) {
        stage.world().setAmbient("zone-b", 97);
        execution.succeed(Map.of());
      }

      @Override
      public CostAnswer cost(Map<String, Object> parameters) {
        return new CostAnswer(Optional.of(0.2), Optional.of(0.2), Optional.empty());
      }
    };
  }

  private static JavaProcess container(Stage stage, Path directory) throws Exception {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of("container", "--main", "127.0.0.1:" + stage.platform().port(), "--name", "kitchen"),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
