package org.maestro.agents.goals;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.agents.calls.OwnMember;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.ContractWords;
import org.maestro.agents.content.GoalWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The goals that an agent has of its own accord (Three-layered architecture, 2 and 5.1; M15, M16,
 * M91). They are pursued with the agent's own members, without the central agent; what these cannot
 * bring about is asked of the central agent as an effect (Three-layered architecture, 1; M5), and
 * again while it is wanting. Agent thread only.
 */
public final class OwnGoals {
  private static final Logger LOG = LoggerFactory.getLogger(OwnGoals.class);
  private static final Duration ASK_AGAIN = Duration.ofSeconds(60);
  private static final int MOST_ATTEMPTS = 3;

  private final MaestroAgent agent;
  private final String name;
  private final Clock clock;
  private final UnmetConditions lacking;
  private final Faces faces;
  private final Deliberation deliberation;
  private final Predicate<String> scripts;
  private final Map<Formula, Own> goals = new LinkedHashMap<>();
  private final Journal journal;
  private final Recovery recovery;
  private Optional<Stakes> stakes = Optional.empty();
  private boolean takenUp;
  private boolean ended;

  /**
   * @param past of the platform, with which its own goals go on
   * @param scope the members with which it plans
   * @param member the member that is the agent's own; empty: it orders other agents
   */
  public OwnGoals(
      MaestroAgent agent,
      String name,
      Clock clock,
      ReasoningServices mind,
      Story story,
      Past past,
      Predicate<String> scope,
      Optional<OwnMember> member) {
    this.agent = agent;
    this.name = name;
    this.clock = clock;
    this.scripts = word -> mind.knowledge().home().scripts().containsKey(word);
    this.faces = new Faces(agent, name, mind.knowledge());
    String prefix = name + "-";
    Past own = past.of(prefix);
    this.journal = new AgentJournal(agent, clock, own.journal());
    this.recovery = own.recovery();
    this.lacking =
        new UnmetConditions(
            mind.planner(), word -> mind.knowledge().home().vocabulary().isFluent(word));
    this.deliberation =
        new Deliberation(
            agent,
            clock,
            new ReasoningServices(
                new ScopedKnowledge(mind.knowledge(), scope), lacking, mind.decisionTime()),
            entry -> told(entry, story),
            journal,
            prefix,
            scope,
            (goal, sentence) -> LOG.warn("{}: {}", goal, sentence),
            member,
            faces);
  }

  /** The manager of these goals, for what else its agent is asked to do. */
  public Coordinator manager() {
    return deliberation.coordinator();
  }

  /** At which its agent is seen. */
  public Faces faces() {
    return faces;
  }

  public void begin() {
    deliberation.begin();
  }

  public void end() {
    ended = true;
    deliberation.end();
  }

  public void memberPresent(String member, AID its, Optional<String> life) {
    deliberation.memberPresent(member, its, life);
  }

  public void memberLost(String member, String reason) {
    deliberation.memberLost(member, reason);
  }

  /** Whether the member is counted on. */
  public boolean isPresent(String member) {
    return deliberation.coordinator().isPresent(member);
  }

  /** See {@link Deliberation#agentMoves}. */
  public void agentMoves(String agentName) {
    deliberation.agentMoves(agentName);
  }

  /** The agent is no more; returns the members that it stood for. */
  public Set<String> agentGone(String agentName, String reason) {
    return deliberation.agentGone(agentName, reason);
  }

  /** News of what is under way for one of them. */
  public void heard(Words words) {
    ContractWords.tell(words, deliberation.coordinator());
  }

  /** A member's agent asks for what a goal of another manager wants of the member. */
  public void askedToYield(ACLMessage message, Words words) {
    deliberation.askedToYield(message, words);
  }

  /** The same of the agent's own member. */
  public void askedToYield(ComponentWant want) {
    deliberation.coordinator().wantedElsewhere(want);
  }

  private void pursue(Formula goal) {
    if (!goals.containsKey(goal)) {
      Own own = new Own(goal);
      goals.put(goal, own);
      own.submit();
    }
  }

  /**
   * Has only these goals from now on.
   *
   * @param worth of each of them; empty: a script has its own, and others are not weighed
   */
  public void pursueOnly(List<Formula> wanted, Optional<Stakes> worth) {
    stakes = worth;
    takeUp();
    List.copyOf(goals.values()).stream()
        .filter(own -> !wanted.contains(own.goal))
        .forEach(
            own -> {
              goals.remove(own.goal);
              own.cancel(name);
            });
    wanted.forEach(this::pursue);
  }

  /** Goals that had no end when the platform did go on, once. */
  private void takeUp() {
    if (takenUp) {
      return;
    }
    takenUp = true;
    recovery.goals().forEach(goal -> goals.put(goal.request().goal(), new Own(goal)));
    deliberation
        .coordinator()
        .resume(
            recovery,
            Duration.ZERO,
            news -> find(news.goalId()).ifPresent(own -> own.heard(news)),
            outcome -> find(outcome.id()).ifPresent(own -> own.over(outcome)));
    tellCentre();
  }

  private Optional<Own> find(String goalId) {
    return goals.values().stream().filter(own -> own.id.equals(goalId)).findFirst();
  }

  /** Returns whether there is such a goal, and it had not ended yet. */
  boolean cancel(String goalId, String who) {
    return find(goalId).filter(found -> found.cancel(who)).isPresent();
  }

  /** See {@link Coordinator#answer}. */
  void answer(String part, String text, Respondent by, Consumer<Optional<AnswerRefusal>> then) {
    deliberation
        .coordinator()
        .answer(
            part,
            text,
            by,
            refusal -> {
              tellCentre();
              then.accept(refusal);
            });
  }

  List<GoalStatus> statuses() {
    return deliberation.coordinator().goals();
  }

  /** A central agent is there, which knows nothing of what was asked of another before it. */
  public void centreReturned() {
    tellCentre();
    goals.values().forEach(Own::centreReturned);
  }

  /** The list of goals tells who waits for an answer, too. */
  private void told(StoryEntry entry, Story story) {
    story.tell(entry);
    if (entry.kind() == StoryEntry.Kind.SAID) {
      agent.tell(this::tellCentre);
    }
  }

  /** So that the list of goals is whole. */
  private void tellCentre() {
    for (GoalStatus status : statuses()) {
      agent.send(
          agent.message(
              ACLMessage.INFORM, agent.getAID(AgentNames.COORDINATOR), GoalWords.status(status)));
    }
  }

  /** One of them. */
  private final class Own implements Coordinator.Answer {
    private final Formula goal;
    private String id = "";
    private Optional<DelegatedGoal> petition = Optional.empty();
    private int attempts;

    private Own(Formula goal) {
      this.goal = goal;
    }

    /** One that was there before a restart; what was asked for it then is heard of again. */
    private Own(Recovery.UnfinishedGoal former) {
      this.goal = former.request().goal();
      this.id = former.id();
      former.memory().asked().ifPresent(asked -> open(asked.effect()).await(asked.petition()));
    }

    private void submit() {
      attempts++;
      GoalRequest request = new GoalRequest(goal, name);
      try {
        id =
            deliberation
                .coordinator()
                .submit(stakes.map(request::with).orElse(request), this, this::heard, this::over);
      } catch (InvalidGoalException e) {
        LOG.warn("{} does not pursue its goal: {}", name, e.getMessage());
      }
    }

    @Override
    public void accepted(String goalId) {
      if (goals.get(goal) == this) {
        tellCentre();
      } else {
        deliberation.coordinator().cancel(goalId, name);
      }
    }

    @Override
    public void refused(String reason) {
      attempts--;
      LOG.warn("{} does not pursue its goal for now: {}", name, reason);
      clock.schedule(ASK_AGAIN, name, () -> agent.tell(this::submitAgain));
    }

    private void submitAgain() {
      if (goals.get(goal) == this && !ended) {
        submit();
      }
    }

    private void heard(HeldNews news) {
      tellCentre();
      if (!news.kind().isSo() && !news.reasons().isEmpty()) {
        askOthers();
      }
    }

    private void over(GoalOutcome outcome) {
      tellCentre();
      if (outcome.state() == GoalState.FAILED && isScript()) {
        LOG.info("{} tries {} again in a minute: {}", name, outcome.id(), outcome.reasons());
        clock.schedule(ASK_AGAIN, name, () -> agent.tell(this::submitAgain));
      } else if (outcome.state() == GoalState.FAILED) {
        askOthers();
      }
    }

    /** Its steps are its agent's own; nobody else is asked to do them. */
    private boolean isScript() {
      return goal instanceof Formula.Atom atom && scripts.test(atom.predicate());
    }

    private boolean isWanting() {
      return statuses().stream()
          .filter(status -> status.id().equals(id))
          .anyMatch(
              status ->
                  status.state() == GoalState.FAILED
                      || status.state() == GoalState.WAITING && goal instanceof Formula.Keep);
    }

    private void askOthers() {
      if (petition.isEmpty() && !ended) {
        open(effect()).send();
      }
    }

    private DelegatedGoal open(Formula effect) {
      DelegatedGoal opened =
          new DelegatedGoal(
              agent,
              effect,
              petitionId -> journal.write(new JournalEntry.Asked(id, petitionId, effect)),
              this::answered);
      petition = Optional.of(opened);
      return opened;
    }

    /** What is lacking; after some attempts, the goal itself. */
    private Formula effect() {
      if (goal instanceof Formula.Keep keep) {
        return new Formula.Keep(lacking.of(keep.body()));
      }
      return attempts < MOST_ATTEMPTS ? lacking.of(goal) : goal;
    }

    private void answered(DelegatedGoal asked, Optional<String> problem) {
      petition = Optional.empty();
      if (problem.isPresent()) {
        LOG.info("{} asked in vain for {}: {}", name, asked.effect(), problem.get());
        clock.schedule(ASK_AGAIN, name, () -> agent.tell(this::askAgain));
      } else if (!asked.effect().equals(goal)) {
        submit();
      }
    }

    private void askAgain() {
      if (goals.get(goal) == this && isWanting()) {
        askOthers();
      }
    }

    private void centreReturned() {
      petition = Optional.empty();
      askAgain();
    }

    private boolean cancel(String who) {
      petition.ifPresent(DelegatedGoal::withdraw);
      petition = Optional.empty();
      boolean cancelled = deliberation.coordinator().cancel(id, who);
      tellCentre();
      return cancelled;
    }
  }
}
