package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Which site devices, robots and lamps of a process of their own join. */
class SiteOptionsTest {
  @TempDir private Path parent;
  private RuntimeDirectory here;
  private ServerSocket broker;

  @BeforeEach
  void aBrokerAnswersAndNoPlatformRuns() throws IOException {
    here = RuntimeDirectory.at(parent.resolve("run"));
    broker = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
  }

  @AfterEach
  void end() throws IOException {
    broker.close();
  }

  @Test
  void thePlatformThatRunsHereUnlessAnotherIsNamed() {
    runs("hall", Optional.of(broker()));

    SiteOptions.Found site = read().find(here);

    assertThat(site.name()).isEqualTo("hall");
    assertThat(site.broker()).isEqualTo(URI.create(broker()));
    assertThat(site.isSecured()).isFalse();
  }

  @Test
  void aBrokerThatIsNamedIsThatOfMaestroUnlessTheSiteIsNamedToo() {
    runs("hall", Optional.of("tcp://127.0.0.1:1"));

    SiteOptions.Found usual = read("--broker", broker()).find(here);
    SiteOptions.Found other = read("--broker", broker(), "--site", "crater").find(here);

    assertThat(usual.name()).isEqualTo("maestro");
    assertThat(usual.broker()).isEqualTo(URI.create(broker()));
    assertThat(other.name()).isEqualTo("crater");
  }

  @Test
  void oneOfSeveralIsChosenByName() {
    runs("hall", Optional.of("tcp://127.0.0.1:1"));
    runs("loft", Optional.of(broker()));

    assertThat(read("--site", "loft").find(here).name()).isEqualTo("loft");
    assertThatThrownBy(() -> read().find(here))
        .isInstanceOf(CommandException.class)
        .hasMessage("Several platforms run (hall, loft); choose one with --site NAME.");
  }

  @Test
  void withoutAnyASentenceTellsWhatToDo() {
    assertThatThrownBy(() -> read().find(here))
        .isInstanceOf(CommandException.class)
        .hasMessage(
            "No platform runs here; start one with ./maestro run, or name a broker with --broker"
                + " URI.");
    runs("hall", Optional.empty());
    assertThatThrownBy(() -> read("--site", "loft").find(here))
        .isInstanceOf(CommandException.class)
        .hasMessage("No platform loft runs here, but hall; or name a broker with --broker URI.");
    assertThatThrownBy(() -> read().find(here))
        .isInstanceOf(CommandException.class)
        .hasMessage("The platform hall has no broker that others reach; name one with --broker.");
  }

  private String broker() {
    return "tcp://127.0.0.1:" + broker.getLocalPort();
  }

  private static SiteOptions read(String... arguments) {
    SiteOptions options = new SiteOptions();
    new CommandLine(new Any(options)).parseArgs(arguments);
    return options;
  }

  @CommandLine.Command(name = "any")
  private record Any(@CommandLine.Mixin SiteOptions options) {}

  private void runs(String name, Optional<String> broker) {
    here.add(
        new RuntimeDirectory.Running(
            name,
            ProcessHandle.current().pid(),
            "127.0.0.1",
            1099,
            broker,
            Optional.empty(),
            Optional.empty()));
  }
}
