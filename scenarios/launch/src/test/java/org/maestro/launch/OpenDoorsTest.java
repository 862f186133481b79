package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;

/**
 * Every process of a site, every port on which it listens, and who comes there without being asked.
 */
@Tag("full")
@Isolated("its time is wall time, which others beside it would take")
class OpenDoorsTest {
  private static final Duration LIMIT = Duration.ofSeconds(90);
  private static final String NAME = "doors";
  private static final Pattern PLATFORM = Pattern.compile("JADE on port (\\d+)");
  private static final long SEED = 20;

  @TempDir Path directory;

  private final Map<String, JavaProcess> processes = new LinkedHashMap<>();
  private final List<JavaProcess> strangers = new ArrayList<>();
  private Path files;
  private boolean secured;
  private EmbeddedBroker broker;
  private int main;

  @AfterEach
  void end() throws IOException {
    for (JavaProcess stranger : strangers) {
      stranger.close();
    }
    List<JavaProcess> all = new ArrayList<>(processes.values());
    for (int last = all.size() - 1; last >= 0; last--) {
      all.get(last).close();
    }
    if (broker != null) {
      broker.close();
    }
  }

  /** So that what is looked for below can be seen at all. */
  @Test
  void aPlainPlatformRunsTheCodeOfAStranger() throws Exception {
    Path witness = directory.resolve("witness");
    JavaProcess plain =
        JavaProcess.start(
            "jade.Boot",
            List.of(
                "-host",
                "127.0.0.1",
                "-local-host",
                "127.0.0.1",
                "-port",
                "0",
                "-nomtp",
                "-detect-main",
                "false",
                "-file-dir",
                directory + "/",
                "-services",
                "jade.core.mobility.AgentMobilityService"));
    processes.put("plain", plain);
    Pattern address = Pattern.compile("jicp://[^:]+:(\\d+)");
    until(() -> address.matcher(plain.errors()).find() && plain.errors().contains("is ready"));
    Matcher found = address.matcher(plain.errors());
    assertThat(found.find()).isTrue();
    strangers.add(
        Stranger.in(directory)
            .joining(Integer.parseInt(found.group(1)), "evil", "Main-Container", witness));
    until(() -> Files.exists(witness));
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void nobodyComesInWithoutBeingAsked(boolean isSecured) throws Exception {
    assumeTrue(Files.isDirectory(Path.of("/proc/self/fd")), "ports are looked for in /proc");
    secured = isSecured;
    begin();
    Map<String, Set<Integer>> doors = new LinkedHashMap<>();
    for (Map.Entry<String, JavaProcess> process : processes.entrySet()) {
      doors.put(process.getKey(), Doors.of(process.getValue().pid()));
    }
    long attic = attic();
    doors.put("attic", Doors.of(attic));
    assertThat(doors.get("run"))
        .as("for containers, letters and the console")
        .hasSize(secured ? 1 : 4);
    assertThat(doors.get("lights")).hasSize(1);
    assertThat(doors.get("attic")).hasSize(1);
    try (JavaProcess asking = ask("goal", "(nextTo Cup Bob)")) {
      until(() -> asking.output().contains("asks for"));
      assertThat(Doors.of(asking.pid())).as("of who asks, for the answers").hasSize(1);
    }
    assertThat(doors.get("devices")).isEmpty();
    assertThat(doors.get("standby")).isEmpty();

    List<Socket> silent = new ArrayList<>();
    Set<Integer> all = new TreeSet<>();
    doors.values().forEach(all::addAll);
    all.add(broker.uri().getPort());
    for (int port : all) {
      for (int time = 0; time < 3; time++) {
        silent.add(Stranger.silent(port));
      }
    }
    Set<Integer> forContainers = new TreeSet<>(Set.of(main));
    forContainers.addAll(doors.get("lights"));
    forContainers.addAll(doors.get("attic"));
    Random random = new Random(SEED);
    for (int port : all) {
      Stranger.rubbish(port, random);
      for (Object gadget : Stranger.gadgets()) {
        boolean answered = Stranger.serialised(port, gadget);
        assertThat(answered || !forContainers.contains(port)).as("port %d", port).isTrue();
      }
    }
    Map<Path, JavaProcess> tried = joinEverywhere(all);
    // Who speaks JADE's protocol to a door for something else may wait there as long as he likes.
    for (int port : secured ? all : forContainers) {
      tried.forEach(
          (witness, stranger) -> {
            if (witness.toString().contains("-" + port + "-")) {
              until(() -> isTurnedAway(stranger));
            }
          });
    }
    for (Map.Entry<Path, JavaProcess> one : tried.entrySet()) {
      assertThat(one.getKey()).as(() -> one.getValue().errors()).doesNotExist();
      if (secured) {
        assertThat(one.getValue().errors()).doesNotContain("is ready");
      }
    }
    for (Socket socket : silent) {
      awaitEnd(socket);
    }
    if (!secured) {
      for (String kind : List.of("run", "lights")) {
        assertThat(said(kind))
            .contains("agents need no java.io.File", "agents need no java.net.URL")
            .contains("agents need no java.util.HashSet", "jade.stranger.Mover");
      }
    }
    processes.forEach((kind, process) -> assertThat(process.isAlive()).as(kind).isTrue());
    assertThat(ProcessHandle.of(attic)).isPresent();
    JavaProcess.Ended goal = ask("goal", "(in rose zone-b)").await(LIMIT);
    assertThat(goal.output()).as(goal.errors()).contains("Reached");
  }

  private String said(String kind) {
    return processes.get(kind).output() + processes.get(kind).errors();
  }

  private Map<Path, JavaProcess> joinEverywhere(Set<Integer> ports) throws IOException {
    Stranger stranger = Stranger.in(directory);
    Map<Path, JavaProcess> tried = new LinkedHashMap<>();
    for (int port : ports) {
      for (String destination : List.of("Main-Container", "lights")) {
        String name = "evil-" + port + "-" + destination.toLowerCase(Locale.ROOT);
        Path witness = directory.resolve(name);
        JavaProcess joining = stranger.joining(port, name, destination, witness);
        strangers.add(joining);
        tried.put(witness, joining);
      }
    }
    return tried;
  }

  private static boolean isTurnedAway(JavaProcess stranger) {
    String said = stranger.errors();
    return !stranger.isAlive()
        || said.contains("Abort transfer")
        || said.contains("joining agent platform");
  }

  private static void awaitEnd(Socket socket) throws IOException {
    try (socket) {
      socket.setSoTimeout((int) LIMIT.toMillis());
      socket.getInputStream().readAllBytes();
    } catch (SocketTimeoutException open) {
      throw new AssertionError("Port " + socket.getPort() + " keeps who says nothing", open);
    } catch (SocketException hungUp) {
      assertThat(hungUp).hasMessageContaining("reset");
    }
  }

  private void begin() throws Exception {
    if (secured) {
      files = directory.resolve("site");
      SecureSite.make(
          files,
          NAME,
          List.of("localhost", "127.0.0.1"),
          List.of("maestro", "container-lights", "container-attic"),
          home(),
          List.of("console"));
    }
    broker =
        secured
            ? EmbeddedBroker.startSecured(SiteSecurity.open(files).artemis(), 0)
            : EmbeddedBroker.start();
    Path hosts = Files.writeString(directory.resolve("hosts.json"), hosts());
    List<String> run =
        List.of(
            "run",
            "bob",
            "--no-sim",
            "--broker",
            broker.uri().toString(),
            "--name",
            NAME,
            "--data",
            directory.resolve("data").toString());
    List<String> first = new ArrayList<>(run);
    first.addAll(List.of("--port", "0", "--hosts", hosts.toString()));
    if (!secured) {
      first.addAll(List.of("--mtp", "0"));
    }
    processes.put("run", start(first));
    JavaProcess platform = processes.get("run");
    until(() -> PLATFORM.matcher(platform.output()).find());
    Matcher where = PLATFORM.matcher(platform.output());
    assertThat(where.find()).isTrue();
    String port = where.group(1);
    main = Integer.parseInt(port);
    processes.put(
        "devices",
        start(
            List.of(
                "devices",
                "bob",
                "--scene",
                "bob-dark",
                "--speed",
                "5",
                "--site",
                NAME,
                "--broker",
                broker.uri().toString())));
    processes.put(
        "lights", start(List.of("container", "--main", "127.0.0.1:" + port, "--name", "lights")));
    List<String> standby = new ArrayList<>(run);
    standby.addAll(List.of("--port", port, "--standby"));
    processes.put("standby", start(standby));
    until(() -> processes.get("lights").output().contains("The container lights runs here"));
    until(() -> processes.get("standby").output().contains("Standing by"));
    until(() -> processes.get("devices").output().contains("Simulated devices"));
    until(this::isAtticThere);
  }

  private static List<String> home() throws IOException {
    return new HomeLoader()
            .load(
                Files.readString(Path.of("../assembly/src/main/resources/homes/bob.ttl")),
                "bob.ttl")
            .devices()
            .keySet()
            .stream()
            .toList();
  }

  private String hosts() throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                Maestro.class.getName(),
                "container",
                "--main={main}",
                "--name={name}"));
    if (secured) {
      command.addAll(List.of("--security", files.toString()));
    }
    return new ObjectMapper()
        .writeValueAsString(Map.of("hosts", List.of(Map.of("name", "attic", "command", command))));
  }

  private JavaProcess start(List<String> words) throws IOException {
    List<String> arguments = new ArrayList<>(words);
    if (secured) {
      arguments.addAll(List.of("--security", files.toString()));
    }
    return maestro(arguments);
  }

  private JavaProcess ask(String... words) throws IOException {
    return maestro(List.of(words));
  }

  /** Logging as for users: what is refused stands in what it says. */
  private JavaProcess maestro(List<String> arguments) throws IOException {
    return JavaProcess.startLogging(
        Maestro.class.getName(), arguments, Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  /** The process of the one host that the platform has started. */
  private long attic() {
    return ProcessHandle.of(processes.get("run").pid())
        .flatMap(run -> run.children().findFirst())
        .map(ProcessHandle::pid)
        .orElse(0L);
  }

  /** When it has joined it listens for other containers. */
  private boolean isAtticThere() {
    try {
      return attic() > 0 && !Doors.of(attic()).isEmpty();
    } catch (IOException gone) {
      return false;
    }
  }

  private void until(BooleanSupplier condition) {
    await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(200))
        .atMost(LIMIT)
        .failFast(this::requireAlive)
        .until(condition::getAsBoolean);
  }

  private void requireAlive() {
    for (JavaProcess process : processes.values()) {
      assertThat(process.isAlive()).as(() -> process.output() + process.errors()).isTrue();
    }
  }
}
