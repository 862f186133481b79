package org.maestro.platform;

import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.HostAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.device.Host;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.supervision.Handover;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.ProcessStart;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.planning.api.Planner;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.NameTakenException;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.jade.SharedParts;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;

/**
 * A container of this process in a platform of another (Three-layered architecture, 3.3.1; M64): as
 * a desk from which to ask, or as the home of a topic's agents. Any thread may use it.
 */
public final class JoinedContainer implements AutoCloseable {
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(20);
  private static final Duration BETWEEN_TRIES = Duration.ofMillis(500);
  private static final int MOST_TRIES = 10;

  private final BiFunction<String, Host, AgentContainer> newContainer;
  private final AgentContainer container;
  private final DeskAgent desk;
  private final AgentTime time;
  private final List<AgentContainer> forAgents = new ArrayList<>();

  /** Guarded by this. */
  private Optional<ThinkingParts> thinking = Optional.empty();

  /** Whether they are being ended; guarded by this. */
  private boolean left;

  private JoinedContainer(
      BiFunction<String, Host, AgentContainer> newContainer,
      AgentContainer container,
      DeskAgent desk,
      AgentTime time) {
    this.newContainer = newContainer;
    this.container = container;
    this.desk = desk;
    this.time = time;
  }

  /** The links of this process to the bus. */
  public interface Links {
    /** Makes it, or gives the one there is. */
    RatsLink of(String controller);

    /** Ends it, if there is one. */
    void letGo(String controller);
  }

  /** Starts a container of that name, which gives this to its agents. */
  private interface Joining {
    /**
     * @param first whether no other container of the platform is in this process
     */
    AgentContainer join(String name, Host its, boolean first);
  }

  /** Joins, with a desk agent named after the container. */
  public static JoinedContainer join(String host, int port, String name, Clock clock) {
    return join(Optional.empty(), host, port, name, clock);
  }

  /**
   * Joins, also from a process that has had platforms of its own.
   *
   * @param platform its name; empty in a process without: the main container tells it
   */
  public static JoinedContainer join(
      Optional<String> platform, String host, int port, String name, Clock clock) {
    return join(platform, host, port, name, clock, Optional.empty());
  }

  /**
   * Joins the platform of a secured site.
   *
   * @param guard by which this process is let in; empty on an open site
   * @throws NameTakenException when another container has the name
   * @throws PlatformStartException when no platform answers there, or it refuses
   */
  public static JoinedContainer join(
      Optional<String> platform,
      String host,
      int port,
      String name,
      Clock clock,
      Optional<Guard> guard) {
    String from = JadeRuntime.requirePlatform(host, port, guard);
    SharedParts shared = SharedParts.fresh();
    Joining joining =
        (called, its, first) ->
            JadeRuntime.join(
                platform,
                host,
                port,
                called,
                temporaryDirectory(),
                new JadeRuntime.Entry(guard, first, from),
                its,
                shared);
    BiFunction<String, Host, AgentContainer> newContainer =
        (called, its) -> joining.join(called, its, false);
    AgentContainer container = joining.join(name, new Host(), true);
    if (!name(container).equals(name)) {
      ContainerEnds.end(container);
      throw new NameTakenException(name);
    }
    AgentTime time = AgentTime.of(clock);
    DeskAgent desk = new DeskAgent(Birth.of(container), time);
    try {
      JadeRuntime.start(container, name + "-desk", desk);
    } catch (RuntimeException e) {
      // JADE goes on in this process as long as one of its containers does: who tries again would
      // not begin afresh.
      ContainerEnds.abandon(List.of(container));
      throw e;
    }
    return new JoinedContainer(newContainer, container, desk, time);
  }

  /** The container's name in the platform. */
  public String name() {
    return name(container);
  }

  public DeskAgent desk() {
    return desk;
  }

  /** Asks an agent and waits for its final reply; not to be called by an agent. */
  public ACLMessage ask(int performative, String agent, Content... contents) {
    CompletableFuture<ACLMessage> reply = new CompletableFuture<>();
    desk.request(
        performative,
        agent,
        ANSWER_WITHIN,
        message -> {
          if (DeskAgent.isEnd(message)) {
            reply.complete(message);
          }
        },
        contents);
    try {
      return reply.get(ANSWER_WITHIN.toSeconds() + 5, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new PlatformStartException("Interrupted while waiting for " + agent + ".", e);
    } catch (ExecutionException | TimeoutException e) {
      throw new PlatformStartException("The agent " + agent + " did not answer.", e);
    }
  }

  /**
   * Asks to be let in with a container for agents.
   *
   * @throws PlatformStartException when the platform does not let it in
   */
  public Handover ask(ContainerStart start) {
    return Handover.read(Words.of(answer(start, "join").get(0)));
  }

  /**
   * Starts a container for agents; the platform has them begin or come there. To be called once for
   * each container of this process.
   *
   * @param start as it was asked for
   * @return the agents that live there, or are on their way
   */
  public List<String> host(
      ContainerStart start, RatsLink link, BiFunction<String, String, Device> describedBy) {
    AgentContainer home =
        named(start.name(), () -> new Host(new Surroundings(time, link, describedBy)));
    synchronized (this) {
      forAgents.add(home);
    }
    if (!name(home).equals(start.name())) {
      throw new NameTakenException(start.name());
    }
    List<Content> answer = answer(start, "joined");
    for (Content content : answer) {
      if (content.operator().equals(StartWords.OPERATOR)) {
        AgentStart its = StartWords.read(Words.of(content));
        Surroundings here = new Surroundings(time, link, describedBy);
        JadeRuntime.start(home, its.agent(), new GenericAgent(Birth.of(home), here, its));
      }
    }
    return Words.of(answer.get(0)).strings("agents");
  }

  private List<Content> answer(ContainerStart start, String action) {
    ACLMessage reply =
        ask(
            ACLMessage.REQUEST,
            AgentNames.SUPERVISOR,
            Words.content(
                "perform",
                Words.named("action", Words.name(action)),
                Words.named("container", Words.text(start.name())),
                Words.named("topics", start.topics().stream().map(Words::text).toList()),
                Words.named("provides", start.provides().stream().map(Words::text).toList()),
                StartWords.process(ProcessStart.own())));
    List<Content> contents = Words.parse(reply.getContent());
    Words words = Words.of(contents.get(0));
    if (reply.getPerformative() != ACLMessage.INFORM) {
      throw new PlatformStartException(
          words.string("reason").or(() -> words.string("problem")).orElse("Refused."));
    }
    return contents;
  }

  /**
   * Offers this process as a host for agents. To be called once.
   *
   * @param name of the host, and of its container when it has none yet
   * @param provides words, each alone or with a blank and a number
   * @param links makes links under the names of controllers, once it is known where the bus is
   * @throws PlatformStartException when the platform refuses
   */
  public void offer(
      String name,
      List<String> provides,
      Function<Handover, Links> links,
      BiFunction<String, String, Device> describedBy) {
    AgentContainer home;
    synchronized (this) {
      if (forAgents.isEmpty()) {
        forAgents.add(named(name, Host::new));
      }
      home = forAgents.get(0);
    }
    CompletableFuture<Links> bus = new CompletableFuture<>();
    HostAgent host =
        new HostAgent(
            Birth.of(home),
            time,
            new HostAgent.Host() {
              @Override
              public void begin(AgentStart start, String controller) {
                RatsLink link = bus.join().of(controller);
                Surroundings here = new Surroundings(time, link, describedBy);
                JadeRuntime.start(
                    home, start.agent(), new GenericAgent(Birth.of(home), here, start));
              }

              @Override
              public void letGo(String controller) {
                bus.join().letGo(controller);
              }
            });
    JadeRuntime.start(home, AgentNames.ofHost(name), host);
    CompletableFuture<ACLMessage> answered = new CompletableFuture<>();
    host.offer(name, provides, answered::complete);
    bus.complete(links.apply(handover(answered)));
  }

  /**
   * Has parts of the central agent live in this process, as agents of these names. To be called
   * once.
   *
   * @param name of their container when this process has none for agents yet
   * @param home as the platform has it, by the same file
   * @param planner of goals
   * @throws PlatformStartException when the platform has such an agent already
   */
  public void think(String name, Home home, Set<ThinkingPart> parts, Planner planner) {
    synchronized (this) {
      if (forAgents.isEmpty()) {
        forAgents.add(named(name, Host::new));
      }
      thinking =
          Optional.of(
              ThinkingParts.begin(forAgents.get(0), name + "-copy", time, home, parts, planner));
    }
  }

  private static Handover handover(CompletableFuture<ACLMessage> answered) {
    try {
      ACLMessage reply = answered.get(ANSWER_WITHIN.toSeconds() + 5, TimeUnit.SECONDS);
      Words words = Words.of(Words.parse(reply.getContent()).get(0));
      if (reply.getPerformative() != ACLMessage.INFORM) {
        throw new PlatformStartException(words.string("reason").orElse("Refused."));
      }
      return Handover.read(words);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new PlatformStartException("Interrupted while the platform was asked.", e);
    } catch (ExecutionException | TimeoutException e) {
      throw new PlatformStartException("The supervisor of the platform did not answer.", e);
    }
  }

  /**
   * JADE lets go of the name of a container that ended a moment late, and gives one that comes too
   * early another name. That one is ended, and the next one may have the name.
   *
   * @param host makes one for each of them, as it ends with its container
   */
  private AgentContainer named(String wanted, Supplier<Host> host) {
    AgentContainer joined = newContainer.apply(wanted, host.get());
    for (int attempt = 0; attempt < MOST_TRIES && !name(joined).equals(wanted); attempt++) {
      ContainerEnds.end(joined);
      LockSupport.parkNanos(BETWEEN_TRIES.toNanos());
      joined = newContainer.apply(wanted, host.get());
    }
    return joined;
  }

  private static String name(AgentContainer container) {
    try {
      return container.getContainerName();
    } catch (ControllerException e) {
      throw new PlatformStartException("The container ended while it joined.", e);
    }
  }

  /**
   * Has the listener told, once, when the platform has given this process up; then this is to be
   * abandoned, and joined anew by whoever wants to go on.
   */
  public void whenGivenUp(Runnable listener) {
    desk.whenContainerIsGivenUp(listener);
  }

  /** Ends what is of no use any more; does not wait for long. */
  public void abandon() {
    ContainerEnds.abandon(left());
    endThinking();
  }

  @Override
  public void close() {
    left().forEach(ContainerEnds::end);
    endThinking();
  }

  private synchronized void endThinking() {
    thinking.ifPresent(ThinkingParts::close);
    thinking = Optional.empty();
  }

  /** Those that are to be ended: JADE counts a container that is ended twice at once as two. */
  private synchronized List<AgentContainer> left() {
    if (left) {
      return List.of();
    }
    left = true;
    List<AgentContainer> ending = new ArrayList<>(forAgents);
    ending.add(container);
    return ending;
  }

  private static Path temporaryDirectory() {
    try {
      Path directory = Files.createTempDirectory("maestro-jade");
      directory.toFile().deleteOnExit();
      return directory;
    } catch (IOException e) {
      throw new PlatformStartException("No temporary directory can be made.", e);
    }
  }
}
