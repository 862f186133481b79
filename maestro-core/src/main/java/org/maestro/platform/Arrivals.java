package org.maestro.platform;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BiFunction;
import org.maestro.deployment.AgentStart;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.members.DescriptionVerdict;
import org.maestro.ontology.home.Device;
import org.maestro.platform.failover.AgentFailover;
import org.maestro.platform.failover.FormerCallers;
import org.maestro.platform.failover.TakeoverLinks;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Gives agents to members that none stands for yet (Three-layered architecture, 2 and 1; M3, M7).
 * Any thread may call.
 */
final class Arrivals {
  private static final Logger LOG = LoggerFactory.getLogger(Arrivals.class);

  /** Who asks to be let in waits a little longer. */
  private static final Duration PLACED_WITHIN = Duration.ofSeconds(15);

  private final KnowledgeBase knowledge;
  private final BiFunction<String, String, Device> describedBy;
  private final Clock clock;
  private final Deployer deployer;
  private final AgentFailover rescue;
  private final FormerCallers callers;
  private final RatsLink link;
  private final Map<String, Refusal> refused = new ConcurrentHashMap<>();
  private final CountDownLatch placed = new CountDownLatch(1);
  private final Complaints complaints = new Complaints();

  /**
   * @param describedBy reads a description (first argument) that a member (second) sent
   * @param rescue finds hosts for agents that need what this process does not provide
   * @param callers who called members for what is under way since before
   * @param link by which members are told why they get no agent
   */
  Arrivals(
      KnowledgeBase knowledge,
      BiFunction<String, String, Device> describedBy,
      Clock clock,
      Deployer deployer,
      AgentFailover rescue,
      FormerCallers callers,
      RatsLink link) {
    this.knowledge = knowledge;
    this.describedBy = describedBy;
    this.clock = clock;
    this.deployer = deployer;
    this.rescue = rescue;
    this.callers = callers;
    this.link = link;
  }

  /** The devices of the home get their agents. */
  void ofHome() {
    knowledge.home().devices().values().stream()
        .sorted(Comparator.comparingDouble(Device::order).thenComparing(Device::id))
        .forEach(device -> place(device.id(), topic(device)));
    placed.countDown();
  }

  /** Waits a bounded time; false when the home's devices have no agents even then. */
  boolean awaitHome() {
    try {
      return placed.await(PLACED_WITHIN.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** A member that no agent stands for yet gets one. */
  void memberChanged(RatsLink.Member member) {
    if (member.phase() != MemberStatus.Phase.READY) {
      refused.remove(member.id());
    }
    boolean isRefused =
        Optional.ofNullable(refused.get(member.id())).filter(one -> one.isOf(member)).isPresent();
    if (!isRefused
        && member.phase() == MemberStatus.Phase.READY
        && member.description().isPresent()
        && deployer.deployment().agentOf(member.id()).isEmpty()
        && !deployer.deployment().isDismissed(member.id())
        && !knowledge.home().devices().containsKey(member.id())) {
      Clock.Ticket untilItHasStarted = clock.hold("the start of " + member.id());
      Thread starter =
          new Thread(
              () -> {
                try (untilItHasStarted) {
                  receive(member, member.description().get());
                }
              },
              "agent-starter");
      starter.setDaemon(true);
      starter.start();
    }
  }

  /** One whose description cannot be understood stays without an agent; the others go on. */
  private void receive(RatsLink.Member member, String description) {
    String id = member.id();
    try {
      String topic = topic(describedBy.apply(description, id));
      if (isCurrent(member, description)) {
        refused.remove(id);
        link.tell(DescriptionVerdict.accepted(id, member.boot()));
      }
      place(id, topic);
    } catch (RuntimeException e) {
      if (!isCurrent(member, description)) {
        return;
      }
      String why = DescriptionVerdict.inSentences(e);
      refused.put(id, new Refusal(why, clock.instant(), description, member.boot()));
      link.tell(DescriptionVerdict.refused(id, member.boot(), e));
      if (complaints.isDue(id)) {
        LOG.warn("The member {} gets no agent: {}", id, Complaints.shortened(why));
      }
    }
  }

  /** Whether it is there, and has not described itself otherwise meanwhile. */
  private boolean isCurrent(RatsLink.Member member, String description) {
    return link.members().stream()
        .filter(now -> now.id().equals(member.id()))
        .filter(now -> now.phase() == MemberStatus.Phase.READY)
        .anyMatch(
            now ->
                now.boot().equals(member.boot())
                    && now.description().equals(Optional.of(description)));
  }

  /**
   * Members that are there and cannot be used, since what they say of themselves is faulty; those
   * that nobody has known before have no agent.
   *
   * @param used members that can be used
   */
  SortedMap<String, Refusal> refused(Collection<String> used) {
    SortedMap<String, Refusal> all = new TreeMap<>(refused);
    for (RatsLink.Member member : link.members()) {
      if (member.phase() == MemberStatus.Phase.READY
          && !used.contains(member.id())
          && deployer.deployment().agentOf(member.id()).isPresent()) {
        fault(member).ifPresent(refusal -> all.put(member.id(), refusal));
      }
    }
    return Collections.unmodifiableSortedMap(all);
  }

  private Optional<Refusal> fault(RatsLink.Member member) {
    return member.description().flatMap(description -> fault(member, description));
  }

  private Optional<Refusal> fault(RatsLink.Member member, String description) {
    try {
      Device unusedAsOnlyFaultsCountHere = describedBy.apply(description, member.id());
      return Optional.empty();
    } catch (RuntimeException e) {
      return Optional.of(
          new Refusal(
              DescriptionVerdict.inSentences(e), clock.instant(), description, member.boot()));
    }
  }

  /**
   * Why a member gets no agent, and since when.
   *
   * @param description the one that is refused
   * @param boot the life that has told it
   */
  record Refusal(String why, Instant since, String description, String boot) {

    boolean isOf(RatsLink.Member member) {
      return boot.equals(member.boot()) && member.description().equals(Optional.of(description));
    }
  }

  private void place(String member, String topic) {
    AgentStart start = AgentStart.of(member, topic);
    Optional<String> former = callers.of(member);
    if (former.isPresent()) {
      String container = former.flatMap(TakeoverLinks::container).orElse(topic);
      if (deployer.await(start, container)) {
        rescue.awaits(member, former.get());
      }
    } else if (rescue.fitsHere(member)) {
      deployer.place(start);
    } else {
      deployer.deployment().placed(start);
      rescue.settle(member);
    }
  }

  private static String topic(Device device) {
    return device.container().orElse(Supervision.DEFAULT_TOPIC);
  }
}
