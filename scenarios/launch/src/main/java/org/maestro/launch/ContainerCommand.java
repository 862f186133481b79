package org.maestro.launch;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.Deployment;
import org.maestro.platform.ThinkingPart;
import org.maestro.rats.time.PacedClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Joins a container for agents to a platform, from this process. */
@Command(
    name = "container",
    description =
        "Join a container to a running platform, until Ctrl-C: agents live in it that are its"
            + " topic's, or that are added or moved there.")
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
      description =
          "Of the container. When the platform has one of that name for a topic, such as lights,"
              + " this one takes its place.")
  private String name;

  @Option(
      names = "--topic",
      paramLabel = "TOPIC",
      split = ",",
      description = "Whose agents move here, and begin here from now on; any word.")
  private List<String> topics = List.of();

  @Option(
      names = "--provides",
      paramLabel = "WHAT",
      split = ",",
      description = "What this host has that agents may need, such as microphone,gpu.")
  private List<String> provides = List.of();

  @Option(
      names = "--part",
      paramLabel = "PART",
      split = ",",
      description =
          "Part of the central agent that lives here as an agent itself: language understands what"
              + " people say, goals pursues what it is asked for. Needs --home.")
  private Set<ThinkingPart> parts = Set.of();

  @Option(
      names = "--home",
      paramLabel = "HOME",
      completionCandidates = Shipped.Homes.class,
      description =
          "Of the platform, for parts that live here: the name or file that it was started with.")
  private Optional<String> home = Optional.empty();

  private final PacedClock clock = new PacedClock(1);
  private final AtomicInteger attempts = new AtomicInteger();
  private final AtomicReference<@Nullable HostedContainer> hosted = new AtomicReference<>();

  @Override
  public Integer call() throws InterruptedException {
    if (!parts.isEmpty() && home.isEmpty()) {
      throw CommandException.badInput(
          "A part of the central agent has to know the home; give its name or file by --home.");
    }
    begin();
    UntilStopped.run(spec.commandLine().getOut(), announcement(), () -> hosted().close());
    return ExitCode.DONE;
  }

  /** There from the first beginning on. */
  private HostedContainer hosted() {
    return Objects.requireNonNull(hosted.get());
  }

  private void begin() {
    HostedContainer begun =
        HostedContainer.begin(
            Endpoint.parse(main),
            start(),
            thinking(),
            attempts.incrementAndGet(),
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

  private ContainerStart start() {
    Deployment.requireContainerName(name);
    topics.forEach(Deployment::requireContainerName);
    return new ContainerStart(name, set(topics), set(provides), false);
  }

  private Optional<HostedContainer.Thinking> thinking() {
    return parts.isEmpty()
        ? Optional.empty()
        : home.map(Shipped::home).map(its -> new HostedContainer.Thinking(its, parts));
  }

  private static Set<String> set(List<String> words) {
    return new TreeSet<>(words.stream().map(String::strip).toList());
  }

  private String announcement() {
    List<String> agents = hosted().agents();
    String what =
        agents.isEmpty()
            ? "The container %s runs here, empty; ./maestro agent move ID --to %s brings an agent."
                .formatted(name, name)
            : "The container %s runs here, with %s.".formatted(name, String.join(", ", agents));
    if (!parts.isEmpty()) {
      return "The container %s runs here, and thinks: %s."
          .formatted(
              name,
              parts.stream()
                  .map(part -> part.name().toLowerCase(Locale.ROOT))
                  .sorted()
                  .collect(Collectors.joining(", ")));
    }
    return provides.isEmpty() ? what : what + " It provides " + String.join(", ", provides) + ".";
  }

  /** It was frozen or cut off, and others act in its place now. */
  private void joinAgain(HostedContainer former) {
    PrintWriter out = spec.commandLine().getOut();
    out.println("The platform has given the container " + name + " up; it joins again.");
    former.abandon();
    while (hosted.get() == former) {
      try {
        begin();
        out.println(announcement());
      } catch (RuntimeException e) {
        // JADE throws what it likes where a platform is only half there.
        LOG.info("{} cannot join yet: {}", name, e.getMessage());
        LockSupport.parkNanos(BETWEEN_TRIES.toNanos());
      }
    }
  }
}
