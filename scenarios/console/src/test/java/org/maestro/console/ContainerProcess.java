package org.maestro.console;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.maestro.agents.supervision.Handover;
import org.maestro.assembly.SiteBus;
import org.maestro.deployment.ContainerStart;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.JoinedContainer;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;

/** Another process with a container, which has taken a topic's agents; killed when closed. */
final class ContainerProcess implements AutoCloseable {
  private final Process process;

  private ContainerProcess(Process process) {
    this.process = process;
  }

  /**
   * @param port of the platform's main container
   * @param topic whose agents it takes, and the container's name
   */
  static ContainerProcess start(int port, String topic) throws IOException {
    return new ContainerProcess(
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                ContainerProcess.class.getName(),
                String.valueOf(port),
                topic)
            .redirectErrorStream(true)
            .redirectOutput(new File("/dev/null"))
            .start());
  }

  long pid() {
    return process.pid();
  }

  boolean isAlive() {
    return process.isAlive();
  }

  /** Stops it as it stands: it holds what it has, and does nothing. */
  void freeze() throws IOException, InterruptedException {
    new ProcessBuilder("kill", "-STOP", String.valueOf(process.pid())).start().waitFor();
  }

  /** Ends it as a power cut would. */
  void kill() {
    process.destroyForcibly().onExit().join();
  }

  @Override
  public void close() {
    kill();
  }

  /** The process itself: port and topic. */
  public static void main(String[] arguments) throws InterruptedException {
    Clock clock = new PacedClock(1);
    String topic = arguments[1];
    ContainerStart start = new ContainerStart(topic, Set.of(topic), Set.of(), false);
    JoinedContainer container =
        JoinedContainer.join(
            "127.0.0.1", Integer.parseInt(arguments[0]), topic + "-hand-over", clock);
    Handover handover = container.ask(start);
    SiteBus bus = new SiteBus(URI.create(handover.brokerUri()), handover.site(), Optional.empty());
    String controller = "container-" + topic;
    DescriptionReader reader =
        new DescriptionReader(new HomeLoader().vocabularyWith(handover.words()), handover.words());
    List<String> agents =
        container.host(
            start,
            BusLink.connectForWatched(
                controller, handover.site(), bus.transports().apply(controller), clock, bus.kind()),
            reader::read);
    if (!agents.isEmpty()) {
      new CountDownLatch(1).await();
    }
  }
}
