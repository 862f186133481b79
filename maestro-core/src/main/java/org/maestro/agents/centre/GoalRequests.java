package org.maestro.agents.centre;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.maestro.agents.content.GoalWords;
import org.maestro.agents.content.HeldReport;
import org.maestro.agents.content.SpeechWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.GoalCheck;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Requester;
import org.maestro.coordination.api.Respondent;
import org.maestro.dialogue.UtteranceCheck;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.AccessList;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.ontology.home.Rule;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * The requests of others to the central agent about goals: to take one on, to tell its end, to
 * cancel one, to explain one, to list them. Agent thread only.
 */
public final class GoalRequests {
  /** Who asks for what the home's file has begun. */
  private static final String OF_THE_HOME = "the home";

  private final MaestroAgent agent;
  private final KnowledgeBase knowledge;
  private final Coordinator coordinator;
  private final ToldStories stories;
  private final Endings endings;
  private final PlanRequests plans;
  private final PrivateGoals privately;
  private final Speakers speakers;
  private final GoalsOfOthers others = new GoalsOfOthers();
  private final Map<String, Formula> takenUp = new HashMap<>();

  public GoalRequests(
      MaestroAgent agent, KnowledgeBase knowledge, Coordinator coordinator, ToldStories stories) {
    this.agent = agent;
    this.knowledge = knowledge;
    this.coordinator = coordinator;
    this.stories = stories;
    this.endings = new Endings(agent::reply);
    this.plans = new PlanRequests(agent, coordinator);
    this.speakers = new Speakers(knowledge::home);
    this.privately = new PrivateGoals(knowledge, agent::getHap);
  }

  /** Goals of who was the central agent before are asked for here from now on. */
  public void takeUp(Recovery recovery) {
    recovery.goals().forEach(goal -> takenUp.put(goal.id(), goal.request().goal()));
    recovery.ended().forEach(goal -> endings.ended(goal.request().goal(), goal.outcome()));
  }

  /** Holds a rule of the home under its name, as one who asks for it would have it. */
  void hold(Rule rule) {
    coordinator.hold(
        rule.name(),
        new GoalRequest(rule.goal(), OF_THE_HOME),
        outcome -> endings.ended(rule.goal(), outcome));
  }

  /** Takes on what is wanted by one who is no agent, and hears of its end by its story. */
  void want(GoalRequest request) {
    coordinator.submit(request, outcome -> endings.ended(request.goal(), outcome));
  }

  /** One of them has come to its end. */
  public void ended(GoalOutcome outcome) {
    endings.ended(takenUp.remove(outcome.id()), outcome);
  }

  public void goal(ACLMessage message, Words words) {
    if (message.getPerformative() != ACLMessage.REQUEST) {
      agent.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "initCNP is understood in a request only, and this message is another: "
              + ACLMessage.getPerformative(message.getPerformative())
              + ".");
      return;
    }
    Optional<Formula> stated = words.find("goal").flatMap(this::formula);
    if (stated.isEmpty()) {
      agent.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "initCNP needs a goal, such as (initCNP (:goal (nextTo Cup Bob))).");
      return;
    }
    state(message, words, stated.get());
  }

  /** The goal is taken on, if it can be and who asks for it may; he is told, and how it ends. */
  void state(ACLMessage message, Words words, Formula goal) {
    Caller requester = Caller.of(message, agent.getHap()).askingFor(words.string("for"));
    if (!mayAsk(requester, message)
        || isKeptBack(message, privately.objection(message, words, goal))) {
      return;
    }
    try {
      coordinator.submit(
          GoalWords.request(
              goal,
              new Requester(requester.toString(), speakers.of(requester, words)).toString(),
              words,
              agent.clock().now()),
          answer(message),
          news -> answer(message, news),
          outcome -> endings.ended(goal, outcome));
    } catch (InvalidGoalException e) {
      agent.reply(message, ACLMessage.REFUSE, invalid(e));
    }
  }

  /**
   * Takes the goals of one sentence on, if all of them can be; who says it is told so.
   *
   * @return whether they are taken on
   */
  boolean state(Said said, SaidGoals goals) {
    if (!mayAsk(said.caller(), said.message())
        || goals.goals().stream().anyMatch(goal -> isKeptBack(said, goal))) {
      return false;
    }
    try {
      GoalCheck check = new GoalCheck(knowledge.home());
      List<GoalRequest> asked = new ArrayList<>();
      for (Formula goal : goals.goals()) {
        asked.add(request(said, goal));
        check.check(asked.get(asked.size() - 1));
      }
      asked.forEach(one -> state(said, one, goals));
      return true;
    } catch (InvalidGoalException e) {
      agent.reply(said.message(), ACLMessage.REFUSE, invalid(e));
      return false;
    }
  }

  private void state(Said said, GoalRequest one, SaidGoals goals) {
    Optional<BegunGoal> begun = goals.begun(one.goal());
    if (begun.isPresent()) {
      begun.get().tell(goals.answer());
      begun.get().follow(outcome -> goals.ended(one.goal(), outcome));
      return;
    }
    coordinator.submit(
        one,
        goals.answer(),
        news -> answer(said.message(), news),
        outcome -> {
          endings.ended(one.goal(), outcome);
          goals.ended(one.goal(), outcome);
        });
  }

  private GoalRequest request(Said said, Formula goal) {
    return GoalWords.request(goal, said.requester(), said.words(), agent.clock().now());
  }

  private boolean isKeptBack(Said said, Formula goal) {
    return isKeptBack(said.message(), privately.objection(said.message(), said.words(), goal));
  }

  /** Whether the goal tells nothing that who says it may not read. */
  boolean maySpeakOf(Said said, Formula goal) {
    return privately.objection(said.message(), said.words(), goal).isEmpty();
  }

  /** Begins a goal before all was said that states it, or after what was said is taken back. */
  void begin(Said said, Formula goal, Coordinator.Answer answer, Consumer<GoalOutcome> ended) {
    try {
      coordinator.submit(
          request(said, goal),
          answer,
          news -> {},
          outcome -> {
            endings.ended(goal, outcome);
            ended.accept(outcome);
          });
    } catch (InvalidGoalException e) {
      answer.refused(reason(e));
    }
  }

  /** What who says this may read. */
  ReadingRights rights(ACLMessage message, Words words) {
    return privately.rights(message, words);
  }

  private static Content invalid(InvalidGoalException why) {
    return Words.content(
        "inform",
        Words.named("reason", Words.text(reason(why))),
        Words.named("invalid", Words.name("true")));
  }

  private static String reason(InvalidGoalException why) {
    return Objects.requireNonNullElse(why.getMessage(), why.toString());
  }

  /** Who may not is told so. */
  boolean mayAsk(Caller requester, ACLMessage message) {
    boolean mayAsk = AccessList.of(knowledge.home()).knows(requester.names());
    if (!mayAsk) {
      agent.refuse(
          message,
          ACLMessage.REFUSE,
          "No maestro:Permission of the home lets %s ask anybody for anything."
              .formatted(String.join(" or ", requester.names())));
    }
    return mayAsk;
  }

  private Coordinator.Answer answer(ACLMessage message) {
    return new Coordinator.Answer() {
      @Override
      public void accepted(String goalId) {
        agent.reply(message, ACLMessage.AGREE, named("initCNP", goalId));
        endings.await(goalId, message);
      }

      @Override
      public void refused(String reason) {
        agent.reply(
            message,
            ACLMessage.REFUSE,
            Words.content(
                "inform",
                Words.named("reason", Words.text(reason)),
                Words.named("temporary", Words.name("true"))));
      }
    };
  }

  private static Content named(String operator, String goalId) {
    return Words.content(operator, Words.named("goal", Words.name(goalId)));
  }

  /** A goal is a formula, or its text; a class atom may have been read as a term. */
  private Optional<Formula> formula(Words words) {
    return words
        .formula()
        .or(() -> words.terms().stream().findFirst().map(t -> parse(Words.plain(t))));
  }

  private Formula parse(String text) {
    return SlParser.formula(text, knowledge.home().vocabulary()::isFluent);
  }

  /**
   * Of a held goal, each time that it begins or ceases to be so: it is confirmed or disconfirmed.
   */
  private void answer(ACLMessage message, HeldNews news) {
    agent.reply(
        message,
        news.kind().isSo() ? ACLMessage.CONFIRM : ACLMessage.DISCONFIRM,
        HeldReport.words(news));
  }

  /** The end of a goal, for who did not state it, or whose conversation ended with a process. */
  public void await(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    if (!endings.isOver(id)) {
      if (!coordinator.hasGoal(id)) {
        agent.refuse(message, ACLMessage.REFUSE, noSuchGoal(id));
        return;
      }
      agent.reply(message, ACLMessage.AGREE, named("await", id));
    }
    endings.await(id, message);
  }

  /** An agent tells how a goal of its own fares. */
  public void goalOfAnother(ACLMessage message, Words words, Content whole) {
    others.told(
        message.getSender(),
        words.string("goal").orElseThrow(),
        words.string("state").orElseThrow(),
        whole);
  }

  public void cancel(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    Optional<AID> owner = others.owner(id);
    if (owner.isPresent() && !agent.isFromOtherPlatform(message)) {
      forward(
          owner.get(),
          named("cancel", id),
          (performative, contents) -> agent.reply(message, performative, contents));
      return;
    }
    Optional<String> person = words.string("for");
    Caller caller = Caller.of(message, agent.getHap()).askingFor(person);
    String by = person.isPresent() ? caller.toString() : caller.agent();
    if (agent.isFromOtherPlatform(message) && !isOf(id, by)) {
      agent.refuse(
          message, ACLMessage.REFUSE, "The goal " + id + " is not one that " + by + " stated.");
      return;
    }
    if (coordinator.cancel(id, by)) {
      agent.reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("cancelled", Words.name(id))));
    } else {
      agent.refuse(
          message,
          ACLMessage.REFUSE,
          stories.goals().contains(id) ? "The goal " + id + " has ended already." : noSuchGoal(id));
    }
  }

  /** Has another agent answer. */
  private void forward(AID to, Content request, Verdict verdict) {
    agent.ask(
        agent.message(ACLMessage.REQUEST, to, request),
        agent.patience(agent.patience().agreement()),
        answer ->
            verdict.told(
                answer.getPerformative(),
                Words.parse(answer.getContent()).toArray(Content[]::new)));
  }

  /**
   * An answer to a question of a script, also of one of another agent, by who may state goals; told
   * back is when it is taken, or why it is not.
   */
  public void answer(ACLMessage message, Words words) {
    Caller caller = Caller.of(message, agent.getHap()).askingFor(words.string("for"));
    Optional<String> person = words.string("person");
    Optional<String> objection =
        person.flatMap(name -> new UtteranceCheck(knowledge.home()).objection(name, caller.user()));
    if (objection.isPresent()) {
      agent.refuse(message, ACLMessage.REFUSE, objection.get());
    } else if (mayAsk(caller, message)) {
      answer(
          words.string("question").orElse(""),
          words.string("text").orElse(""),
          caller,
          person,
          (performative, contents) -> agent.reply(message, performative, contents));
    }
  }

  /** What becomes of an answer to a question of a script. */
  interface Verdict {
    void told(int performative, Content... contents);
  }

  /**
   * The same, told to whom it concerns here.
   *
   * @param person of the home whose answer it is, where that is known
   */
  void answer(
      String question, String text, Caller caller, Optional<String> person, Verdict verdict) {
    Optional<AID> owner = others.owner(GoalId.whole(question));
    if (owner.isPresent()) {
      forward(
          owner.get(),
          SpeechWords.answer(question, text, Optional.of(caller.toString()), person),
          verdict);
      return;
    }
    coordinator.answer(
        question,
        text,
        new Respondent(caller.toString(), person),
        refusal ->
            verdict.told(
                refusal.isPresent() ? ACLMessage.REFUSE : ACLMessage.INFORM,
                SpeechWords.verdict(question, refusal)));
  }

  private boolean isOf(String id, String requester) {
    return coordinator.goals().stream()
        .anyMatch(goal -> goal.id().equals(id) && goal.requester().equals(requester));
  }

  /** The story of a goal, as far as it was told and from then on. */
  public void subscribe(ACLMessage message, Words words) {
    String id = words.string("story").orElse("");
    if (isPrivate(message, words, id)) {
      return;
    }
    if (stories.goals().contains(id) || coordinator.hasGoal(id)) {
      stories.subscribe(message, id, () -> privately.rights(message, words));
    } else {
      agent.refuse(message, ACLMessage.REFUSE, noSuchGoal(id));
    }
  }

  public void explain(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    if (!stories.goals().contains(id)) {
      agent.refuse(message, ACLMessage.REFUSE, noSuchGoal(id));
    } else if (isPrivate(message, words, id)) {
      return;
    } else if (words.find("step").isPresent()) {
      coordinator.explainChoice(
          id,
          words.find("plan").isPresent()
              ? OptionalInt.of((int) words.number("plan", 0))
              : OptionalInt.empty(),
          (int) words.number("step", 0),
          sentences -> stories.tell(message, id, sentences));
    } else {
      stories.tellAll(message, id);
    }
  }

  /**
   * The goals, or with {@code (query-ref waits)} the wait-for graph, or what is asked of one's
   * plans.
   */
  public void list(ACLMessage message, Words words) {
    Optional<String> planned = PlanRequests.goal(words);
    if (planned.isPresent()) {
      String id = planned.get();
      if (isPrivate(message, words, id)) {
        return;
      }
      if (stories.goals().contains(id) || coordinator.hasGoal(id)) {
        plans.answer(message, words, id);
      } else {
        agent.refuse(message, ACLMessage.REFUSE, noSuchGoal(id));
      }
      return;
    }
    List<Content> lines = new ArrayList<>();
    if (words.terms().contains(new Term.Name("waits"))) {
      coordinator.waits().forEach(wait -> lines.add(GoalWords.wait(wait)));
    } else {
      coordinator.goals().forEach(goal -> lines.add(GoalWords.status(goal)));
      lines.addAll(others.statuses());
    }
    ReadingRights rights = privately.rights(message, words);
    agent.reply(
        message,
        ACLMessage.INFORM,
        lines.stream().map(line -> privately.line(line, rights)).toArray(Content[]::new));
  }

  /** Whether who asks is refused, as the goal uses what is private to him. */
  boolean isPrivate(ACLMessage message, Words words, String id) {
    return isKeptBack(
        message, privately.rights(message, words).objection(stories.privateWords(id)));
  }

  boolean isKeptBack(ACLMessage message, Optional<String> objection) {
    objection.ifPresent(reason -> agent.refuse(message, ACLMessage.REFUSE, reason));
    return objection.isPresent();
  }

  /** What is said of a goal that is not pursued here. */
  String notHere(String id) {
    return others
        .owner(id)
        .map(
            owner ->
                "The goal %s is one of %s, which alone knows what it has changed; state what is to be so instead."
                    .formatted(id, owner.getLocalName()))
        .orElseGet(() -> noSuchGoal(id));
  }

  private String noSuchGoal(String id) {
    if (coordinator.hasHad(id)) {
      return "The goal "
          + id
          + " ended long ago, and nothing of it is kept here any more; its story may still be read"
          + " when no platform runs.";
    }
    return stories.goals().isEmpty()
        ? "There is no goal " + id + "; none was stated yet."
        : "There is no goal " + id + "; there are " + String.join(", ", stories.goals()) + ".";
  }
}
