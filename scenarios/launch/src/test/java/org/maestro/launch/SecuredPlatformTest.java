package org.maestro.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import jade.lang.acl.ACLMessage;
import java.io.ByteArrayInputStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.agents.device.ToldRights;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.fixtures.WireTap;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.jade.NameTakenException;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.stream.StreamReceiver;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.Credentials;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;
import org.slf4j.LoggerFactory;

/**
 * A secured site as processes of others meet it: who joins, who asks whom for what, and what those
 * hear who may not. The agents of the lights live in a process of their own.
 */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
@Isolated("its time is wall time, which others beside it would take")
class SecuredPlatformTest {
  private static final String NAME = "secured-bob";
  private static final Path SHIPPED = Path.of("../assembly/src/main/resources");
  private static final Duration SOON = Duration.ofSeconds(60);

  @TempDir static Path directory;
  private static Path files;
  private static Path homeFile;
  private static final Logger RIGHTS = (Logger) LoggerFactory.getLogger(ToldRights.class);
  private static final ListAppender<ILoggingEvent> told = new ListAppender<>();
  private static final Queue<String> STORY = new ConcurrentLinkedQueue<>();
  private static LocalSite site;
  private static JavaProcess lights;

  @BeforeAll
  static void start() throws Exception {
    files = directory.resolve("site");
    homeFile = directory.resolve("bob.ttl");
    Files.writeString(
        homeFile,
        Files.readString(SHIPPED.resolve("homes/bob.ttl"))
            + """
            home:familyAsks a maestro:Permission ; maestro:caller "console" .
            home:tabletDims a maestro:Permission ; maestro:caller "tablet" ;
              maestro:asks :Lamp .
            :prefers maestro:private true .
            home:Dave a :Person ; rdfs:label "Dave"@en .
            home:Opera a :Show ; rdfs:label "the opera"@en .
            home:dave-evenings a :Preference ; rdfs:label "what Dave likes"@en ;
              :preferenceOf home:Dave ; :preferenceAbout "TV show" ; :prefers home:Opera .
            home:cam-a maestro:offers :streamPictures , :stopStreaming .
            home:consoleIsTold a maestro:Permission ; maestro:caller "console" ;
              maestro:reads :prefers .
            """);
    Home home = new HomeLoader().load(homeFile);
    told.start();
    RIGHTS.setLevel(Level.INFO);
    RIGHTS.addAppender(told);
    SecureSite.make(
        files,
        NAME,
        List.of("localhost", "127.0.0.1"),
        List.of("maestro", "container-lights", "screen"),
        home.devices().keySet(),
        List.of("console", "tablet", "stranger"));
    SiteSettings settings =
        SiteSettings.of(NAME, home)
            .scene(
                SceneLoader.load(
                    "bob-dark.ttl",
                    new ByteArrayInputStream(
                        Files.readAllBytes(SHIPPED.resolve("scenes/bob-dark.ttl"))),
                    home))
            .security(SiteSecurity.open(files))
            .homeFile(homeFile)
            .build();
    site = LocalSite.paced(settings, 10);
    site.platform().onStory(entry -> STORY.add(entry.text()));
    lights =
        command(
            "container", "--main", address(), "--name", "lights", "--security", files.toString());
    List<String> lamps =
        home.devices().keySet().stream().filter(id -> id.startsWith("lamp")).toList();
    await()
        .atMost(SOON)
        .until(
            () ->
                lights.output().contains("The container lights runs here")
                    && site.platform().presentMembers().containsAll(lamps));
  }

  @AfterAll
  static void end() throws Exception {
    if (lights != null) {
      lights.close();
    }
    if (site != null) {
      site.close();
    }
    RIGHTS.detachAppender(told);
    RIGHTS.setLevel(Level.WARN);
  }

  private static String address() {
    return "127.0.0.1:" + site.platform().port();
  }

  private static JavaProcess command(String... arguments) throws Exception {
    return JavaProcess.start(
        Maestro.class.getName(),
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static JavaProcess.Ended goal(Path security, String user, String goal) throws Exception {
    try (JavaProcess asking =
        command(
            "goal", goal, "--main", address(), "--security", security.toString(), "--user", user)) {
      return asking.await(SOON);
    }
  }

  /** Messages between three processes, all of them signed, and checked where they arrive. */
  @Test
  void whoMayAskIsServedAcrossProcesses() throws Exception {
    JavaProcess.Ended ended = goal(files, "console", "(nextTo Cup Bob)");
    assertThat(ended.output() + ended.errors()).contains("Reached in").contains("is set to");
    assertThat(ended.exitCode()).isEqualTo(ExitCode.DONE);
  }

  @Test
  void whoMayNotAskIsRefusedByTheAgentItselfAndByTheCentralAgent() throws Exception {
    try (JoinedContainer tablet = join("tablet")) {
      ACLMessage refusal = ask(tablet, "rose", "goTo");
      assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(refusal.getContent())
          .contains("no maestro:Permission of the home lets tablet")
          .contains("ask rose for goTo");
      assertThat(ask(tablet, "lamp-a1", "adjustLight").getContent())
          .doesNotContain("maestro:Permission");
      ACLMessage failure = askForRose(tablet);
      assertThat(failure.getPerformative()).isEqualTo(ACLMessage.FAILURE);
    }
    await().atMost(SOON).until(() -> told("lets tablet or tablet-desk ask rose for"));
    try (JoinedContainer stranger = join("stranger")) {
      ACLMessage refusal = askForRose(stranger);
      assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(refusal.getContent())
          .contains("No maestro:Permission of the home lets stranger")
          .contains("ask anybody for anything");
    }
  }

  /** What is known of persons is read by permission only (ADE, 4.1; A57). */
  @Test
  void whatDaveLikesIsToldToWhomTheHomePermitsThatAndToNobodyElse() throws Exception {
    try (JoinedContainer console = join("console");
        JoinedContainer tablet = join("tablet")) {
      assertThat(askWhatDaveLikes(console).getContent())
          .contains("(:binding (:show Opera))", "(:source \"bob.ttl\") (:kind described)");
      ACLMessage refusal = askWhatDaveLikes(tablet);
      assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(refusal.getContent())
          .contains("prefers is private in this home, and no maestro:Permission lets tablet")
          .doesNotContain("Opera");
    }
  }

  /** Who sees which agents there are gets at nothing private by that (ADE, 3.1; A30). */
  @Test
  void whoSeesTheListOfAgentsReadsNoPreferences() throws Exception {
    try (JoinedContainer technician = join("tablet")) {
      ACLMessage list =
          technician.ask(ACLMessage.QUERY_REF, AgentNames.SUPERVISOR, Words.content("query-ref"));
      assertThat(list.getPerformative()).isEqualTo(ACLMessage.INFORM);
      assertThat(list.getContent())
          .contains("rose", "lamp-a1", "lights")
          .doesNotContain("Opera", "prefers");
      ACLMessage refusal = askWhatDaveLikes(technician);
      assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(refusal.getContent()).doesNotContain("Opera");
    }
  }

  /** The agent of the lamp lives in another process, and stays as it is (ADE, 3.1; A28). */
  @Test
  void aRightThatIsTakenAwayFromAGuestIsGoneAtHisNextCall() throws Exception {
    String before = Files.readString(homeFile);
    try (JoinedContainer tablet = join("tablet")) {
      assertThat(ask(tablet, "lamp-a1", "adjustLight").getContent())
          .doesNotContain("maestro:Permission");
      rewrite(before.replace("maestro:caller \"tablet\"", "maestro:caller \"nobody\""));
      ACLMessage refusal = ask(tablet, "lamp-a1", "adjustLight");
      assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(refusal.getContent())
          .contains("no maestro:Permission of the home lets tablet", "ask lamp-a1");
      rewrite(before);
      assertThat(ask(tablet, "lamp-a1", "adjustLight").getContent())
          .doesNotContain("maestro:Permission");
    }
  }

  /** Until all agents have said that they go by it. */
  private static void rewrite(String text) throws Exception {
    int before = List.copyOf(told.list).size();
    Files.writeString(homeFile, text);
    await()
        .atMost(SOON)
        .until(
            () ->
                List.copyOf(told.list).stream()
                    .skip(before)
                    .anyMatch(line -> line.getMessage().startsWith("All agents go by")));
  }

  /** Nobody but its own agent says of a member what it is at, and no guest (ADE, 3.1; A23). */
  @Test
  void aGuestSpeaksForNoMemberAndGetsNoAgents() throws Exception {
    try (JoinedContainer tablet = join("tablet")) {
      for (String agent : List.of(AgentNames.COORDINATOR, AgentNames.KNOWLEDGE)) {
        ACLMessage refusal =
            tablet.ask(
                ACLMessage.REQUEST,
                agent,
                Words.content(
                    "inform",
                    Words.named("member", Words.name("rose")),
                    Words.named("phase", Words.name("lost")),
                    Words.named("reason", Words.text("stolen"))));
        assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
        assertThat(refusal.getContent()).contains("is an agent of a guest");
      }
      assertThat(site.platform().presentMembers()).contains("rose");
      ACLMessage refusal =
          tablet.ask(
              ACLMessage.REQUEST,
              AgentNames.SUPERVISOR,
              Words.content(
                  "perform",
                  Words.named("action", Words.name("joined")),
                  Words.named("container", Words.name("tablet")),
                  Words.named("topics", Words.name("robots"))));
      assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
      assertThat(refusal.getContent()).contains("is of a guest");
    }
  }

  /** It has the name of no registry, and is heard by nobody as one (ADE, 3.1; A23). */
  @Test
  void whoIsNotTheSupervisorHasNoAgentMoveAndConfiguresNone() throws Exception {
    try (JoinedContainer tablet = join("tablet")) {
      for (String action : List.of("move", "configure")) {
        ACLMessage refusal =
            tablet.ask(
                ACLMessage.REQUEST,
                "lamp-a1",
                Words.content(
                    "perform",
                    Words.named("action", Words.name(action)),
                    Words.named("container", Words.name("tablet"))));
        assertThat(refusal.getPerformative()).isEqualTo(ACLMessage.REFUSE);
        assertThat(refusal.getContent()).contains("Only the supervisor");
      }
    }
  }

  /** Agents that know each other need nobody between them (ADE, 3.1; A27). */
  @Test
  @Order(Integer.MAX_VALUE)
  void callsGoOnWhenTheSupervisorIsGone() throws Exception {
    try (JoinedContainer tablet = join("tablet")) {
      site.platform().endAgent(AgentNames.SUPERVISOR);
      await()
          .atMost(SOON)
          .until(
              () ->
                  tablet
                      .ask(ACLMessage.QUERY_REF, AgentNames.SUPERVISOR, Words.content("query-ref"))
                      .getContent()
                      .contains("There is no agent named supervisor"));
      assertThat(ask(tablet, "lamp-a1", "adjustLight").getContent())
          .doesNotContain("maestro:Permission")
          .doesNotContain("There is no agent");
      assertThat(ask(tablet, "rose", "goTo").getContent())
          .contains("no maestro:Permission of the home lets tablet");
    }
    JavaProcess.Ended ended = goal(files, "console", "(nextTo Cup Bob)");
    assertThat(ended.exitCode()).isEqualTo(ExitCode.DONE);
  }

  /** What devices say all the time, and by which password one hears it (ADE, 2 and 5; A31). */
  @Test
  void whoTapsTheWireOfTheBusReadsNothing() throws Exception {
    URI bus = site.broker().orElseThrow();
    Credentials user = SiteSecurity.open(files).password("container-lights");
    Queue<String> heard = new ConcurrentLinkedQueue<>();
    try (WireTap tap = new WireTap(bus.getPort())) {
      PahoTransport listening =
          new PahoTransport(
              URI.create(bus.getScheme() + "://" + bus.getHost() + ":" + tap.port()), user);
      listening.subscribe(
          "rats/1/" + NAME + "/member/#",
          Transport.RetainedMessages.SEND,
          message -> heard.add(new String(message.payload(), UTF_8)));
      listening.open(
          Optional.empty(),
          new Transport.ConnectionListener() {
            @Override
            public void connected() {
              // What is retained comes of itself.
            }

            @Override
            public void lost(String reason) {
              // It tries again.
            }
          });
      try {
        await().atMost(SOON).until(() -> heard.stream().anyMatch(text -> text.contains("lamp")));
      } finally {
        listening.close();
      }
      assertThat(tap.bytes()).isGreaterThan(heard.stream().mapToInt(String::length).sum());
      assertThat(heard.stream().filter(text -> text.contains("lamp"))).noneMatch(tap::hasHeard);
      assertThat(tap.hasHeard(user.password().orElseThrow())).isFalse();
    }
  }

  /** Pictures of a room on their way to another room's screen (ADE, 2 and 5; A31, A44). */
  @Test
  void whoTapsTheWireOfAStreamSeesNothingOfIt() throws Exception {
    URI bus = site.broker().orElseThrow();
    Credentials user = SiteSecurity.open(files).password("screen");
    Queue<byte[]> seen = new ConcurrentLinkedQueue<>();
    Queue<String> ends = new ConcurrentLinkedQueue<>();
    try (WireTap tap = new WireTap(bus.getPort());
        PacedClock clock = new PacedClock(1)) {
      StreamReceiver receiver =
          StreamReceiver.open(
              new StreamReceiver.Wanted("cam-a", "streamPictures", Map.of("frequency", 0.2)),
              "screen",
              NAME,
              new PahoTransport(
                  URI.create(bus.getScheme() + "://" + bus.getHost() + ":" + tap.port()), user),
              clock,
              SiteKind.SECURED,
              new StreamReceiver.Listener() {
                @Override
                public void received(StreamReceiver.Received received) {
                  seen.add(received.frame().data());
                }

                @Override
                public void ended(Optional<String> reason) {
                  reason.ifPresent(ends::add);
                }
              });
      try {
        await().atMost(SOON).until(() -> seen.size() >= 2 || !ends.isEmpty());
      } finally {
        receiver.close();
        receiver.left().get(SOON.toSeconds(), TimeUnit.SECONDS);
      }
      assertThat(ends).isEmpty();
      assertThat(tap.bytes()).isGreaterThan(seen.stream().mapToInt(data -> data.length).sum());
      assertThat(seen)
          .noneMatch(
              data -> tap.hasHeard(Base64.getEncoder().encodeToString(data).substring(0, 60)))
          .noneMatch(
              data -> tap.hasHeard(Base64.getEncoder().encodeToString(data).substring(600, 660)));
      assertThat(tap.hasHeard("streamPictures")).isFalse();
      assertThat(tap.hasHeard("image/png")).isFalse();
    }
  }

  private static ACLMessage askWhatDaveLikes(JoinedContainer asking) {
    return asking.ask(
        ACLMessage.QUERY_REF,
        AgentNames.KNOWLEDGE,
        Words.content(
            "query-ref", Words.formula(SlParser.formula("(prefers dave-evenings ?show)"))));
  }

  private static boolean told(String part) {
    return STORY.stream().anyMatch(text -> text.contains(part));
  }

  /** The main container lets go of a name a moment after who had it has left. */
  private static JoinedContainer join(String user) {
    return await()
        .atMost(SOON)
        .ignoreExceptionsInstanceOf(NameTakenException.class)
        .until(() -> joined(user), Objects::nonNull);
  }

  private static JoinedContainer joined(String user) {
    return JoinedContainer.join(
        Optional.of(site.platform().desk().getHap()),
        "127.0.0.1",
        site.platform().port(),
        user,
        new PacedClock(1),
        Optional.of(Guard.open(SiteSecurity.open(files), user)));
  }

  private static ACLMessage askForRose(JoinedContainer asking) {
    return asking.ask(
        ACLMessage.REQUEST,
        AgentNames.COORDINATOR,
        Words.content("initCNP", Words.named("goal", Words.text("(in rose zone-b)"))));
  }

  private static ACLMessage ask(JoinedContainer asking, String agent, String feature) {
    return asking.ask(
        ACLMessage.REQUEST,
        agent,
        Words.content("perform", Words.named("feature", Words.name(feature))));
  }

  @Test
  void whoHasNoCertificateOrTokenIsRefusedAndToldWhyAndThePlatformGoesOn() throws Exception {
    Path stolen = copy("stolen");
    Files.writeString(stolen.resolve("users/console/join-token"), "guessed\n");
    try (JavaProcess plain =
        JavaProcess.start(
            "jade.Boot",
            List.of(
                "-container",
                "-host",
                "127.0.0.1",
                "-port",
                String.valueOf(site.platform().port()),
                "-local-host",
                "127.0.0.1"))) {
      JavaProcess.Ended ended = goal(stolen, "console", "(in rose zone-b)");
      assertThat(ended.exitCode()).isEqualTo(ExitCode.OUTSIDE);
      assertThat(ended.errors().strip())
          .startsWith("maestro: ")
          .contains("console does not show the site's join token")
          .doesNotContain("\n");
      await().atMost(SOON).until(() -> plain.errors().contains("joining agent platform"));
      assertThat(plain.output() + plain.errors()).doesNotContain("is ready");
    }
    assertThat(site.platform().agents()).isNotEmpty();
  }

  /** The process has three containers, of which two are for other things than letting others in. */
  @Test
  void aProcessHasOneDoorHoweverManyContainersItHasAndNoStrangerComesIn() throws Exception {
    assumeTrue(Files.isDirectory(Path.of("/proc/self/fd")), "ports are looked for in /proc");
    Set<Integer> doors = Doors.of(lights.pid());
    assertThat(doors).hasSize(1);
    int door = doors.iterator().next();
    Path witness = directory.resolve("witness");
    try (JavaProcess evil =
        Stranger.in(directory).joining(door, "evil", "Main-Container", witness)) {
      await().atMost(SOON).until(() -> evil.errors().contains("joining agent platform"));
      assertThat(evil.errors()).doesNotContain("is ready");
    }
    assertThat(witness).doesNotExist();
  }

  private static Path copy(String name) throws Exception {
    Path copy = directory.resolve(name);
    try (var all = Files.walk(files)) {
      for (Path file : all.toList()) {
        Files.copy(file, copy.resolve(files.relativize(file)), StandardCopyOption.COPY_ATTRIBUTES);
      }
    }
    return copy;
  }
}
