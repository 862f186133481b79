package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.joran.JoranConfigurator;
import ch.qos.logback.classic.util.LogbackMDCAdapter;
import ch.qos.logback.core.joran.spi.JoranException;
import jade.core.AID;
import jade.core.Agent;
import jade.core.behaviours.CyclicBehaviour;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.device.Host;
import org.maestro.agents.pulse.ProcessPulse;
import org.maestro.display.HybridTime;
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.MailWitness;
import org.maestro.platform.jade.Premises;
import org.maestro.platform.jade.SharedParts;
import org.maestro.platform.jade.Sockets;
import org.maestro.platform.wires.Wires;
import org.maestro.rats.time.HybridClock;

/**
 * Logs of three hosts whose clocks are minutes apart are merged in the order of cause and effect,
 * as what they send each other carries their times (ADE, 3.3; A43).
 */
class MergedLogTest {
  private static final Duration LIMIT = Duration.ofSeconds(30);
  private static final int ROUNDS = 3;
  private static final String PLATFORM = "merged-log";

  @TempDir private Path directory;

  private static String said(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintStream both = new PrintStream(out, true, StandardCharsets.UTF_8);
    int code = Maestro.commandLine(both, both).execute(arguments);
    return code + " " + out.toString(StandardCharsets.UTF_8).strip();
  }

  @Test
  void whatHasNoTimeOfAHybridClockIsLeftOutAndWhatIsNotThereIsASentence() throws Exception {
    Path old = Files.writeString(directory.resolve("old.log"), "12:00:00.000 INFO before\n");

    assertThat(said("log", "--merge", old.toString()))
        .isEqualTo("0 Lines that are left out, as they have no time by which to order them: 1");
    assertThat(said("log", "--merge", directory.resolve("none.log").toString()))
        .startsWith("2 maestro: There is no log " + directory.resolve("none.log") + "; name files");
    assertThat(said("log")).startsWith("0 /").endsWith("maestro.log");
  }

  /** A host with its own clock and log; all three are in this process. */
  private final class Machine {
    private final LoggerContext log = new LoggerContext();
    private final SharedParts parts;
    private final Path file;

    Machine(String name, Duration off) throws JoranException {
      HybridClock clock = new HybridClock(Clock.offset(Clock.systemUTC(), off));
      parts = new SharedParts(new Wires(), new ProcessPulse(), new MailWitness(clock));
      file = directory.resolve(name + ".log");
      log.setMDCAdapter(new LogbackMDCAdapter());
      log.putProperty("maestro.log", file.toString());
      log.putObject(HybridTime.CLOCK, clock);
      JoranConfigurator configurator = new JoranConfigurator();
      configurator.setContext(log);
      configurator.doConfigure(MergedLogTest.class.getResource("/logback.xml"));
    }

    void note(String message) {
      log.getLogger("round").info(message);
    }
  }

  /** Notes what comes, and sends it on to the next; the first begins each round. */
  private static final class Passing extends Agent {
    private static final long serialVersionUID = 1L;
    private final transient Machine machine;
    private final transient CountDownLatch rounds;
    private final String next;
    private final boolean isFirst;
    private int round;

    Passing(Machine machine, CountDownLatch rounds, String next, boolean isFirst) {
      this.machine = machine;
      this.rounds = rounds;
      this.next = next;
      this.isFirst = isFirst;
    }

    @Override
    protected void setup() {
      addBehaviour(
          new CyclicBehaviour() {
            private static final long serialVersionUID = 1L;

            @Override
            public void action() {
              if (receive(MessageTemplate.MatchPerformative(ACLMessage.INFORM)) != null) {
                pass();
              } else {
                block();
              }
            }
          });
      if (isFirst) {
        pass();
      }
    }

    private void pass() {
      round++;
      machine.note("%s has round %d".formatted(getLocalName(), round));
      rounds.countDown();
      ACLMessage message = new ACLMessage(ACLMessage.INFORM);
      message.addReceiver(new AID(next, AID.ISLOCALNAME));
      if (round <= ROUNDS) {
        send(message);
      }
    }
  }

  @Test
  void logsOfThreeHostsWithWrongClocksAreInOneCausalOrder() throws Exception {
    Machine a = new Machine("a", Duration.ZERO);
    Machine b = new Machine("b", Duration.ofMinutes(-7));
    Machine c = new Machine("c", Duration.ofMinutes(5));
    CountDownLatch rounds = new CountDownLatch(3 * ROUNDS + 1);
    int port = Sockets.claim(0);
    AgentContainer main =
        JadeRuntime.main(
            PLATFORM, port, directory, new Host(), Optional.empty(), a.parts, Premises.usual());
    try {
      List<AgentController> agents =
          List.of(
              join(port, "b", b).acceptNewAgent("b", new Passing(b, rounds, "c", false)),
              join(port, "c", c).acceptNewAgent("c", new Passing(c, rounds, "a", false)),
              main.acceptNewAgent("a", new Passing(a, rounds, "b", true)));
      for (AgentController agent : agents) {
        agent.start();
      }
      assertThat(rounds.await(LIMIT.toSeconds(), TimeUnit.SECONDS)).isTrue();
    } finally {
      ContainerEnds.end(main);
    }
    Stream.of(a, b, c).forEach(machine -> machine.log.stop());
    Files.writeString(b.file, "\tat a.stack.Trace\n", StandardOpenOption.APPEND);

    List<String> merged =
        Printed.by("log", "--merge", c.file.toString(), b.file.toString(), a.file.toString())
            .lines()
            .toList();

    assertThat(merged)
        .filteredOn(line -> line.contains(" has round "))
        .extracting(
            line -> line.replaceFirst("^([abc])[.]log .* - ([abc] has round \\d)$", "$1: $2"))
        .containsExactly(
            "a: a has round 1",
            "b: b has round 1",
            "c: c has round 1",
            "a: a has round 2",
            "b: b has round 2",
            "c: c has round 2",
            "a: a has round 3",
            "b: b has round 3",
            "c: c has round 3",
            "a: a has round 4");
    int last = merged.stream().map(line -> line.contains("b has round 3")).toList().indexOf(true);
    assertThat(merged.get(last + 1))
        .as("what belongs to a line")
        .isEqualTo("b.log \\u0009at a.stack.Trace");
  }

  private AgentContainer join(int port, String name, Machine machine) {
    return JadeRuntime.join(
        Optional.of(PLATFORM),
        "127.0.0.1",
        port,
        name,
        directory,
        new JadeRuntime.Entry(Optional.empty(), false),
        new Host(),
        machine.parts);
  }
}
