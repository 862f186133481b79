package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** What people type wrongly, or at a bad moment: one sentence and the right exit code. */
class CommandLineTest {
  @TempDir Path directory;

  private record Said(int exitCode, String out, String err) {
    private long sentences() {
      return err.lines().filter(line -> line.startsWith("maestro: ")).count();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "dance | 2 | There is no command dance",
        "help gaol | 2 | There is no command gaol; write goal, if that is meant",
        "demo bob-bright | 2 | There is no demo bob-bright",
        "demo --console --json | 2 | --console stays, --json prints and ends; leave one away",
        "demo --speed 0 | 2 | --speed is above 0",
        "run | 2 | Missing required parameter",
        "run nowhere.ttl | 2 | There is no home file nowhere.ttl",
        "run bob --speed fast | 2 | Invalid value for option '--speed'",
        "run bob --name B! | 2 | is no name for a platform",
        "run bob --broker tcp://127.0.0.1:1 --broker-port 1 | 2 | leave one away",
        "run bob --broker-port 70000 | 2 | --broker-port is between 0 and 65535",
        "run bob --mtp 7778 --security site | 2 | A secured site hears only whom its own processes"
            + " vouch for",
        "run bob --console 70000 | 2 | --console takes a port between 0 and 65535, HOST:PORT, or"
            + " off; not \"70000\"",
        "run bob --console on | 2 | --console takes a port between 0 and 65535, HOST:PORT, or off;"
            + " not \"on\"",
        "run bob --console 0.0.0.0:0 | 2 | An open site serves its console on this machine alone",
        "run bob --scene nowhere.ttl | 2 | There is no scene file",
        "run bob --broker localhost | 2 | is no broker",
        "run bob --gui --name tested | 3 | There is no display for the JADE GUI",
        "devices bob --only rose,tim --broker tcp://127.0.0.1:1 | 2 | no device tim",
        "devices bob --broker tcp://127.0.0.1:1 | 3 | No MQTT broker answers",
        "zigbee bob --gateway tcp://127.0.0.1:1 --broker tcp://127.0.0.1:1 | 3 | No MQTT broker"
            + " answers",
        "player exploration --robot rover --server x:1 --at 1 --broker tcp://x:1 | 2 | is no place"
            + " to stand",
        "player exploration --robot rex --server x:1 --at 1 --broker tcp://x:1 | 2 | no device rex",
        "ros exploration --server x:1 --robot rover --at 1 --broker tcp://x:1 | 2 | is no place to"
            + " stand",
        "ros exploration --server x:1 --robot rover --broker tcp://x:1 | 2 | Say where rover"
            + " stands",
        "ros exploration --server x:1 --broker tcp://x:1 | 2 | Name what stands behind the server",
        "ros bob --server x:1 --camera camera-1=odom --broker tcp://x:1 | 2 | no device camera-1",
        "ros bob --server x:1 --camera cam-a=odom --broker tcp://x:1 | 2 | \"odom\" is no topic",
        "ros bob --server x:1 --camera cam-a=/seen --broker tcp://x:1 | 2 | is no rosbridge server;"
            + " write ws://HOST:PORT",
        "ros bob --server ws://x:1 --ros 3 --camera cam-a=/seen --broker tcp://x:1 | 2 | --ros is 1"
            + " or 2, not 3",
        "ros bob --server ws://x:1 --camera cam-a=/seen --pictures cam-b=/image --broker tcp://x:1"
            + " | 2 | --pictures names cam-b",
        "ros bob --server ws://x:1 --camera cam-a=/seen --sensor cam-a=/lux --broker tcp://x:1 | 2"
            + " | cam-a is named twice",
        "zigbee bob --lamp porch=lamp-9 --gateway tcp://x:1 --broker tcp://x:1 | 2 | no lamp"
            + " lamp-9",
        "device test tcp://127.0.0.1:1 kettle-1 | 3 | No MQTT broker answers",
        "device test tcp://127.0.0.1:1 kettle-1 --call brew=tea | 2 | --call takes a feature and"
            + " its parameters as a JSON object",
        "device | 2 | Say what to do: device test URI ID",
        "calibrate | 2 | Say what to calibrate: calibrate camera HOME.ttl",
        "calibrate camera arena --camera lamp-1 | 2 | one of cam-1, cam-2, cam-3, not lamp-1",
        "calibrate camera arena --thing Cup | 2 | one of GreenObject, RedObject1, RedObject2",
        "calibrate camera arena --places 0 | 2 | There are 1 to 1000 places, not 0",
        "calibrate camera arena --set world.camera.lens=1 | 2 | There is no setting",
        "goal --main nowhere x | 2 | is no address",
        "container --main 127.0.0.1:1 --name lights | 3 | No platform answers at 127.0.0.1:1",
        "container --main 127.0.0.1:1 --name Lights | 2 | is no name for a container",
        "agent | 2 | Say what to do: agent add, move, reconfigure or remove",
        "agent move rose | 2 | Missing required option: '--to=CONTAINER'",
        "check nowhere.ttl | 2 | There is no home file nowhere.ttl"
      })
  void saysWhatIsWrong(String arguments, int exitCode, String sentence) {
    Said said = maestro(arguments.split(" "));

    assertThat(said.exitCode()).isEqualTo(exitCode);
    assertThat(said.err()).contains(sentence).doesNotContain("\tat ");
    assertThat(said.sentences()).isEqualTo(1);
    assertThat(said.out()).isEmpty();
  }

  @Test
  void aBusyPortIsASentence() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      Said said =
          maestro("run", "bob", "--name", "busy", "--port", String.valueOf(taken.getLocalPort()));

      assertThat(said.exitCode()).isEqualTo(3);
      assertThat(said.err()).contains("Port " + taken.getLocalPort() + " is in use");
    }
  }

  @Test
  void whatIsNoExceptionIsASentenceToo() {
    assertThat(failing(new OutOfMemoryError("Java heap space")))
        .isEqualTo("maestro: The memory of this process does not suffice (Java heap space).");
    assertThat(failing(new StackOverflowError()))
        .isEqualTo(
            "maestro: The program itself is at fault (java.lang.StackOverflowError); the log says"
                + " where.");
  }

  private static String failing(Error failure) {
    ByteArrayOutputStream told = new ByteArrayOutputStream();
    Runnable command =
        () -> {
          throw failure;
        };
    int exitCode =
        Maestro.carriedOut(
            new CommandLine(CommandSpec.wrapWithoutInspection(command)),
            new PrintStream(told, true, StandardCharsets.UTF_8));
    assertThat(exitCode).isEqualTo(ExitCode.OUTSIDE);
    return told.toString(StandardCharsets.UTF_8).strip();
  }

  @Test
  void debugShowsTheStackTrace() {
    assertThat(maestro("demo", "bob-bright", "--debug").err()).contains("\tat ");
  }

  @Test
  void checkFindsNoFaultInTheShippedHomes() {
    assertThat(Shipped.HOMES)
        .allSatisfy(home -> assertThat(maestro("check", home).exitCode()).isZero());
  }

  @Test
  void checkTellsEveryFaultWithItsLine() throws IOException {
    Path home = directory.resolve("bad.ttl");
    Files.writeString(
        home, "@prefix maestro: <https://w3id.org/maestro#> .\n<#a> a maestro:Room ;\n");

    Said said = maestro("check", home.toString());

    assertThat(said.exitCode()).isEqualTo(1);
    assertThat(said.out()).contains("bad.ttl:").containsPattern("\\d+ faults?\\.");
  }

  @Test
  void helpListsWhatWorks() {
    Said said = maestro("--help");

    assertThat(said.exitCode()).isZero();
    assertThat(said.out()).contains("demo", "run", "goal", "why", "check");
  }

  @Test
  void helpIsACommandToo() {
    assertThat(maestro("help")).isEqualTo(maestro("--help"));
    assertThat(maestro("help", "goal").out()).isEqualTo(maestro("goal", "--help").out());
  }

  private static Said maestro(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int exitCode =
        Maestro.commandLine(new PrintStream(out), new PrintStream(err)).execute(arguments);
    return new Said(
        exitCode, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
  }
}
