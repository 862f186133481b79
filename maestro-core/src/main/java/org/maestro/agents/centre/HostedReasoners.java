package org.maestro.agents.centre;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Reasoner;
import org.maestro.coordination.api.Recovery;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Formula;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The reasoners of others that are hosted beside the planner: each is shown what is known when that
 * has changed, and what it comes to want is stated as a goal in its name. Agent thread only.
 */
public final class HostedReasoners {
  private static final Logger LOG = LoggerFactory.getLogger(HostedReasoners.class);

  private final MaestroAgent agent;
  private final KnowledgeBase knowledge;
  private final List<Reasoner> reasoners;
  private final GoalRequests requests;
  private final Map<String, Set<Formula>> wantedByName = new HashMap<>();
  private final Set<String> failing = new HashSet<>();
  private final AtomicBoolean isToLook = new AtomicBoolean();

  public HostedReasoners(
      MaestroAgent agent,
      KnowledgeBase knowledge,
      List<Reasoner> reasoners,
      GoalRequests requests) {
    this.agent = agent;
    this.knowledge = knowledge;
    this.reasoners = List.copyOf(reasoners);
    this.requests = requests;
  }

  /** Those in the class path, made anew. Any thread may call. */
  public static List<Reasoner> found() {
    return ServiceLoader.load(Reasoner.class).stream().map(ServiceLoader.Provider::get).toList();
  }

  /**
   * From now on they are asked.
   *
   * @param recovery what of theirs is taken up again, and not to be stated twice
   */
  public void begin(Recovery recovery) {
    if (reasoners.isEmpty()) {
      return;
    }
    recovery.goals().forEach(goal -> wanted(goal.request().requester()).add(goal.request().goal()));
    knowledge.watch(
        change -> {
          if (isToLook.compareAndSet(false, true)) {
            agent.tell(this::look);
          }
        });
    look();
  }

  private Set<Formula> wanted(String name) {
    return wantedByName.computeIfAbsent(name, one -> new LinkedHashSet<>());
  }

  private void look() {
    isToLook.set(false);
    Snapshot known = knowledge.snapshot();
    reasoners.forEach(reasoner -> look(reasoner, known));
  }

  private void look(Reasoner reasoner, Snapshot known) {
    List<Formula> now;
    try {
      now = reasoner.wanted(known);
    } catch (RuntimeException e) {
      LOG.debug("The reasoner {} failed", reasoner.name(), e);
      if (failing.add(reasoner.name())) {
        LOG.warn(
            "The reasoner {} failed, and is asked again after the next change: {}",
            reasoner.name(),
            e.getMessage());
      }
      return;
    }
    failing.remove(reasoner.name());
    Set<Formula> wanted = wanted(reasoner.name());
    wanted.retainAll(now);
    now.stream().filter(wanted::add).forEach(goal -> state(reasoner.name(), goal));
  }

  private void state(String name, Formula goal) {
    try {
      requests.want(new GoalRequest(goal, name));
    } catch (InvalidGoalException e) {
      LOG.warn("The reasoner {} wants what cannot be a goal: {}", name, e.getMessage());
    }
  }
}
