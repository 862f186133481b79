package org.maestro.platform;

import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.maestro.agents.AgentTime;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.HostAgent;
import org.maestro.agents.SupervisorAgent;
import org.maestro.agents.Words;
import org.maestro.ontology.home.Device;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;

/**
 * A container of this process in a platform of another (M64): as a desk from which to ask, or as
 * the home of a topic's agents. Any thread may use it.
 */
public final class JoinedContainer implements AutoCloseable {
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(20);
  private static final Duration BETWEEN_TRIES = Duration.ofMillis(500);
  private static final int MOST_TRIES = 10;

  private final Function<String, AgentContainer> newContainer;
  private final AgentContainer container;
  private final DeskAgent desk;
  private final AgentTime time;
  private Optional<AgentContainer> ofTopic = Optional.empty();

  private JoinedContainer(
      Function<String, AgentContainer> newContainer,
      AgentContainer container,
      DeskAgent desk,
      AgentTime time) {
    this.newContainer = newContainer;
    this.container = container;
    this.desk = desk;
    this.time = time;
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
   * @throws PlatformStartException when no platform answers there, or it refuses
   */
  public static JoinedContainer join(
      Optional<String> platform,
      String host,
      int port,
      String name,
      Clock clock,
      Optional<Guard> guard) {
    JadeRuntime.requirePlatform(host, port, guard);
    BiFunction<String, Boolean, AgentContainer> joining =
        (called, first) ->
            JadeRuntime.join(
                platform,
                host,
                port,
                called,
                temporaryDirectory(),
                new JadeRuntime.Entry(guard, first));
    Function<String, AgentContainer> newContainer = called -> joining.apply(called, false);
    AgentContainer container = joining.apply(name, true);
    AgentTime time = AgentTime.of(clock);
    DeskAgent desk = new DeskAgent(time);
    JadeRuntime.start(container, name + "-desk", desk);
    return new JoinedContainer(newContainer, container, desk, time);
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
   * Takes a topic's members over.
   *
   * @throws PlatformStartException when the platform has no such topic to give
   */
  public SupervisorAgent.Handover take(String topic) {
    ACLMessage reply =
        ask(
            ACLMessage.REQUEST,
            SupervisorAgent.NAME,
            Words.content(
                "perform",
                Words.named("action", Words.name("take")),
                Words.named("topic", Words.text(topic))));
    Words words = Words.of(Words.parse(reply.getContent()).get(0));
    if (reply.getPerformative() != ACLMessage.INFORM) {
      throw new PlatformStartException(
          words.string("reason").or(() -> words.string("problem")).orElse("Refused."));
    }
    List<String> members =
        words.find("members").orElseThrow().terms().stream().map(Words::plain).toList();
    return new SupervisorAgent.Handover(
        words.string("broker").orElseThrow(), words.string("site").orElseThrow(), members);
  }

  /**
   * Starts the generic agents of a topic's members here, in a container of the topic's name. To be
   * called once.
   */
  public void host(
      String topic,
      List<String> members,
      RatsLink link,
      BiFunction<String, String, Device> describedBy) {
    AgentContainer home = named(topic);
    synchronized (this) {
      ofTopic = Optional.of(home);
    }
    for (String member : members) {
      JadeRuntime.start(home, member, new GenericAgent(time, link, member, describedBy));
    }
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
      Function<SupervisorAgent.Handover, Function<String, RatsLink>> links,
      BiFunction<String, String, Device> describedBy) {
    AgentContainer home;
    synchronized (this) {
      home = ofTopic.orElseGet(() -> named(name));
      ofTopic = Optional.of(home);
    }
    CompletableFuture<Function<String, RatsLink>> bus = new CompletableFuture<>();
    HostAgent host =
        new HostAgent(
            time,
            (member, controller) ->
                JadeRuntime.start(
                    home,
                    member,
                    new GenericAgent(time, bus.join().apply(controller), member, describedBy)));
    JadeRuntime.start(home, HostAgent.name(name), host);
    CompletableFuture<ACLMessage> answered = new CompletableFuture<>();
    host.offer(name, provides, answered::complete);
    bus.complete(links.apply(handover(answered)));
  }

  private static SupervisorAgent.Handover handover(CompletableFuture<ACLMessage> answered) {
    try {
      ACLMessage reply = answered.get(ANSWER_WITHIN.toSeconds() + 5, TimeUnit.SECONDS);
      Words words = Words.of(Words.parse(reply.getContent()).get(0));
      if (reply.getPerformative() != ACLMessage.INFORM) {
        throw new PlatformStartException(words.string("reason").orElse("Refused."));
      }
      return new SupervisorAgent.Handover(
          words.string("broker").orElseThrow(), words.string("site").orElseThrow(), List.of());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new PlatformStartException("Interrupted while the platform was asked.", e);
    } catch (ExecutionException | TimeoutException e) {
      throw new PlatformStartException("The supervisor of the platform did not answer.", e);
    }
  }

  /**
   * JADE lets go of the name of a container that ended a moment late, and gives one that comes too
   * early another name. That one is ended, and the next one may have the name; after some tries any
   * name will do.
   */
  private AgentContainer named(String topic) {
    AgentContainer joined = newContainer.apply(topic);
    for (int attempt = 0; attempt < MOST_TRIES && !name(joined).equals(topic); attempt++) {
      JadeRuntime.end(joined);
      LockSupport.parkNanos(BETWEEN_TRIES.toNanos());
      joined = newContainer.apply(topic);
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

  /** Ends what is of no use any more, beside the caller, and waits for nobody. */
  public void abandon() {
    synchronized (this) {
      ofTopic.ifPresent(JadeRuntime::abandon);
    }
    JadeRuntime.abandon(container);
  }

  @Override
  public void close() {
    synchronized (this) {
      ofTopic.ifPresent(JadeRuntime::end);
    }
    JadeRuntime.end(container);
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
