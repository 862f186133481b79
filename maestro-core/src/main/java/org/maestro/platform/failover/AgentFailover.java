package org.maestro.platform.failover;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.deployment.Provision;
import org.maestro.platform.hosts.Backoff;
import org.maestro.platform.hosts.Placing;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds a host for agents that have none: because theirs is gone, or because none has fitted yet.
 * Any thread may call; what takes long is done on threads of its own.
 */
public final class AgentFailover {
  private static final Logger LOG = LoggerFactory.getLogger(AgentFailover.class);

  /**
   * Wall time for the process of a container to join the platform that takes over; not as long as
   * the coordinator waits for members then.
   */
  static final Duration JOINS_AGAIN_WITHIN = Duration.ofSeconds(5);

  /** The host that is this process. */
  private static final String OWN = "";

  private final Ways ways;
  private final Predicate<String> mayBeUsed;
  private final Clock clock;
  private final Backoff backoff = new Backoff(Duration.ofSeconds(1), Duration.ofMinutes(1));
  private final Provision own;
  private final Map<String, Provision> provisionByHost = new TreeMap<>();
  private final Map<String, String> hostByMember = new TreeMap<>();
  private final Map<String, String> controllerByMember = new TreeMap<>();
  private final Map<String, String> holderByController = new TreeMap<>();
  private final Set<String> homeless = new TreeSet<>();
  private final Set<String> awaited = new TreeSet<>();

  /** The measures that can be taken for an agent without a host. */
  public interface Ways {
    Provision needs(String member);

    /** Starts the agent in this process; calls under the controller's name. */
    void beginHere(String member, String controller);

    /**
     * Starts the agent on another host.
     *
     * @param problem is told why it is not, or nothing when it is
     */
    void beginThere(
        String host, String member, String controller, Consumer<Optional<String>> problem);

    /** Nobody takes the member's agent; said to all who count on it. */
    void nobody(String member, String reason);
  }

  /**
   * @param own what this process provides
   * @param controller under whose name this process calls, which nobody takes over
   * @param mayBeUsed whether anybody may call under a controller's name now
   */
  public AgentFailover(
      Ways ways, Clock clock, Provision own, String controller, Predicate<String> mayBeUsed) {
    this.mayBeUsed = mayBeUsed;
    this.ways = ways;
    this.clock = clock;
    this.own = own;
    provisionByHost.put(OWN, own);
    holderByController.put(controller, OWN);
  }

  /** A host is there; agents that only it fits are started there. */
  public void offered(String host, Collection<String> provides) {
    List<String> waiting;
    synchronized (this) {
      provisionByHost.put(host, Provision.of(provides));
      waiting = new ArrayList<>(homeless);
    }
    waiting.forEach(this::settle);
  }

  public synchronized void gone(String host) {
    provisionByHost.remove(host);
    holderByController.values().removeIf(host::equals);
  }

  /** Whether this process provides what the member's agent needs. */
  public synchronized boolean fitsHere(String member) {
    return own.lacks(ways.needs(member)).isEmpty();
  }

  /**
   * The member's agent is no more; the more often that happens, the later it gets another.
   *
   * @param controller under whose name it has called
   */
  public void lost(String member, String controller) {
    synchronized (this) {
      controllerByMember.putIfAbsent(member, controller);
      hostByMember.remove(member);
    }
    later(member);
  }

  /**
   * The member's agent lives in a process that joins again, as far as one can know; if it does not,
   * another is begun in time.
   *
   * @param controller under whose name it has called
   */
  public void awaits(String member, String controller) {
    synchronized (this) {
      controllerByMember.putIfAbsent(member, controller);
      awaited.add(member);
    }
    afterWallTime(
        JOINS_AGAIN_WITHIN,
        member,
        () -> {
          if (hasNotCome(member)) {
            settle(member);
          }
        });
  }

  private synchronized boolean hasNotCome(String member) {
    return awaited.remove(member);
  }

  private void later(String member) {
    Duration delay;
    synchronized (this) {
      delay = backoff.died(member, wallTime());
    }
    if (delay.isZero()) {
      settle(member);
    } else {
      LOG.warn(
          "The agent of {} has no place again; one is sought in {} s", member, delay.toSeconds());
      afterWallTime(delay, member, () -> settle(member));
    }
  }

  private void afterWallTime(Duration delay, String member, Runnable action) {
    clock.schedule(clock.ofWall(delay), member, action);
  }

  private Duration wallTime() {
    return clock.toWall(clock.now());
  }

  /** The member has an agent by other means. */
  public synchronized void settled(String member) {
    awaited.remove(member);
    homeless.remove(member);
    controllerByMember.remove(member);
    hostByMember.remove(member);
  }

  /**
   * The container that had the name of this controller is back.
   *
   * @return the other host on which somebody has called under it
   */
  public synchronized Optional<String> released(String controller) {
    return Optional.ofNullable(holderByController.remove(controller))
        .filter(host -> !host.equals(OWN));
  }

  public synchronized Set<String> homeless() {
    return Collections.unmodifiableSet(new TreeSet<>(homeless));
  }

  /** Finds a host for one that has none. */
  public void settle(String member) {
    Thread settling = new Thread(() -> settle(member, new TreeSet<>()), "agent-starter");
    settling.setDaemon(true);
    settling.start();
  }

  private void settle(String member, Set<String> tried) {
    Provision needs = ways.needs(member);
    Optional<Placing.Host> chosen = Placing.choose(needs, hosts(tried));
    if (chosen.isEmpty() && tried.isEmpty()) {
      stayAway(member, needs);
      return;
    }
    if (chosen.isEmpty()) {
      // All that fit have failed just now, perhaps as its name was not free yet.
      later(member);
      return;
    }
    String host = chosen.get().name();
    Reservation reserved = reserve(member, host);
    try {
      if (chosen.get().own()) {
        ways.beginHere(member, reserved.controller());
      } else {
        ways.beginThere(
            host, member, reserved.controller(), problem -> begun(reserved, problem, needs, tried));
      }
    } catch (RuntimeException e) {
      LOG.warn("{} gets no agent here: {}", member, e.getMessage());
      release(reserved);
      tried.add(host);
      settle(member, tried);
    }
  }

  private void begun(
      Reservation reserved, Optional<String> problem, Provision needs, Set<String> tried) {
    String member = reserved.member();
    String host = reserved.host();
    if (problem.isPresent()) {
      LOG.warn("{} does not start the agent of {}: {}", host, member, problem.get());
      release(reserved);
      tried.add(host);
      Thread next = new Thread(() -> settle(member, tried), "agent-starter");
      next.setDaemon(true);
      next.start();
    } else {
      LOG.info("The agent of {} runs on {} now, which provides {}", member, host, needs.inWords());
    }
  }

  private synchronized List<Placing.Host> hosts(Set<String> tried) {
    List<Placing.Host> hosts = new ArrayList<>();
    provisionByHost.forEach(
        (host, provides) -> {
          if (!tried.contains(host)) {
            int agents = Collections.frequency(hostByMember.values(), host);
            hosts.add(new Placing.Host(host, provides, host.equals(OWN), agents));
          }
        });
    return hosts;
  }

  /**
   * Calls go on under the name under which they began, unless another host has taken that name: on
   * the bus one has a name at a time; nor is a name used that was taken out of the site.
   */
  private synchronized Reservation reserve(String member, String host) {
    homeless.remove(member);
    hostByMember.put(member, host);
    Optional<String> before = Optional.ofNullable(controllerByMember.get(member));
    String usual = TakeoverLinks.controller(host.equals(OWN) ? "here" : host);
    String former = before.filter(mayBeUsed).orElse(usual);
    boolean isNew = holderByController.putIfAbsent(former, host) == null;
    String controller = holderByController.get(former).equals(host) ? former : usual;
    controllerByMember.put(member, controller);
    return new Reservation(member, host, controller, before, former, isNew);
  }

  /**
   * @param before under which name the member's agent called before
   * @param wanted under which name it was to call
   * @param isNew whether nobody had that name
   */
  private record Reservation(
      String member,
      String host,
      String controller,
      Optional<String> before,
      String wanted,
      boolean isNew) {}

  /** It was not begun there. */
  private synchronized void release(Reservation reserved) {
    hostByMember.remove(reserved.member());
    controllerByMember.remove(reserved.member());
    reserved.before().ifPresent(name -> controllerByMember.put(reserved.member(), name));
    if (reserved.isNew()) {
      holderByController.remove(reserved.wanted(), reserved.host());
    }
  }

  private void stayAway(String member, Provision needs) {
    synchronized (this) {
      homeless.add(member);
    }
    ways.nobody(
        member,
        "its agent needs %s, which no host that is there provides".formatted(needs.inWords()));
  }
}
