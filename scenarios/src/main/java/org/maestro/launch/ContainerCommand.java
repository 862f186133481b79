package org.maestro.launch;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.maestro.platform.PlatformStartException;
import org.maestro.rats.time.PacedClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Takes one of a platform's topical containers into this process. */
@Command(
    name = "container",
    description = "Take one of a platform's topical containers over, until Ctrl-C.")
final class ContainerCommand implements Callable<Integer> {
  private static final Logger LOG = LoggerFactory.getLogger(ContainerCommand.class);
  private static final Duration BETWEEN_TRIES = Duration.ofSeconds(1);

  @Spec private CommandSpec spec;

  @Option(
      names = "--main",
      paramLabel = "HOST:PORT",
      required = true,
      description = "Where the platform's JADE main container listens.")
  private String main;

  @Mixin private SecurityOptions security;

  @Option(
      names = "--name",
      paramLabel = "NAME",
      required = true,
      description = "Of the container; the topic, unless --topic or --provides is given.")
  private String name;

  @Option(
      names = "--topic",
      paramLabel = "TOPIC",
      description = "The topic whose agents it takes: robots, cameras, lights, sensors.")
  private Optional<String> topic;

  @Option(
      names = "--provides",
      paramLabel = "WORD",
      split = ",",
      description =
          "What this host has for agents that need it (maestro:hostNeeds), such as microphone or \"memory 512\"; agents of lost hosts are started here too.")
  private List<String> provides = List.of();

  private final PacedClock clock = new PacedClock(1);
  private final AtomicReference<HostedTopic> hosted = new AtomicReference<>();

  @Override
  public Integer call() throws InterruptedException {
    begin();
    UntilStopped.run(spec.commandLine().getOut(), announcement(), () -> hosted.get().close());
    return ExitCode.DONE;
  }

  private void begin() {
    HostedTopic begun =
        HostedTopic.begin(
            Endpoint.parse(main),
            new HostedTopic.Wish(
                name, provides.isEmpty() ? topic.or(() -> Optional.of(name)) : topic, provides),
            clock,
            security.files());
    hosted.set(begun);
    begun.whenGivenUp(
        () -> {
          Thread joining = new Thread(() -> joinAgain(begun), "joining-again");
          joining.setDaemon(true);
          joining.start();
        });
  }

  private String announcement() {
    String has =
        hosted.get().members().isEmpty()
            ? "and waits for agents"
            : "with " + String.join(", ", hosted.get().members());
    return provides.isEmpty()
        ? "The container %s runs here, %s.".formatted(name, has)
        : "The container %s runs here, %s. It provides %s."
            .formatted(name, has, String.join(", ", provides));
  }

  /** It was frozen or cut off, and others act in its place now. */
  private void joinAgain(HostedTopic former) {
    PrintWriter out = spec.commandLine().getOut();
    out.println("The platform has given the container " + name + " up; it joins again.");
    former.abandon();
    while (hosted.get() == former) {
      try {
        begin();
        out.println(announcement());
      } catch (PlatformStartException | CommandException e) {
        LOG.info("{} cannot join yet: {}", name, e.getMessage());
        LockSupport.parkNanos(BETWEEN_TRIES.toNanos());
      }
    }
  }
}
