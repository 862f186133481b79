package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.BeliefWords;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.HeldReport;
import org.maestro.agents.content.OverheardReply;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SaidReply;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.SpeechWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.knowledge.KnowledgeCache;
import org.maestro.agents.lives.AgentLifeListener;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.OtherPlatform;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.coordination.api.AnswerLog;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Utterance;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;

/**
 * The desk at which people (and programs for them) state goals and ask questions (Three-layered
 * architecture, 3; M25). Its methods may be called by any thread; the answers come on the agent's.
 */
public final class DeskAgent extends MaestroAgent implements AgentLifeListener {
  private static final long serialVersionUID = 1L;

  /** The patience of who waits for the end of a goal. */
  public static final Duration NO_END = Duration.ofDays(365);

  private static final int QUESTIONS_KEPT = 256;
  private static final int SPEECHES_KEPT = 200;
  private static final int AGENTS_KEPT = 200;

  private final transient KnowledgeCache knowledge = new KnowledgeCache(this, QUESTIONS_KEPT);

  private final transient List<Consumer<Speech>> listeners = new ArrayList<>();
  private final transient Deque<Speech> recent = new ArrayDeque<>();
  private final transient List<BiConsumer<String, Mood>> watchers = new ArrayList<>();
  private final transient List<Consumer<GivenAnswer>> clerks = new ArrayList<>();
  private final transient AnswerLog answers;
  private final transient Map<String, Mood> moods = BoundedMap.ofNewest(AGENTS_KEPT);

  private final transient Function<String, Optional<String>> agentByRoom;
  private final transient Spokesmen spokesmen;

  /**
   * One that keeps no answers to questions of scripts, of a home in which no room has an agent that
   * listens.
   */
  public DeskAgent(Birth birth, AgentTime time) {
    this(birth, time, (answer, then) -> then.run(), room -> Optional.empty(), Spokesmen.BY_NAME);
  }

  /**
   * @param answers where those to questions of scripts are kept
   * @param agentByRoom the agent that hears what is said in a room, by the room's name, if one does
   * @param spokesmen agents that, like the central one, may have people told something
   */
  public DeskAgent(
      Birth birth,
      AgentTime time,
      AnswerLog answers,
      Function<String, Optional<String>> agentByRoom,
      Spokesmen spokesmen) {
    super(birth, time);
    this.answers = answers;
    this.agentByRoom = agentByRoom;
    this.spokesmen = spokesmen;
  }

  /**
   * Has the listener told, on this agent's thread, of what people are to hear, and of the latest
   * that was said before, as while the platform took up what it was at before a restart.
   */
  public void whenSaid(Consumer<Speech> listener) {
    tell(
        () -> {
          recent.forEach(listener);
          listeners.add(listener);
        });
  }

  /**
   * Has the listener told, on this agent's thread, of each mood that an agent shows, and of the
   * latest of each.
   *
   * @param listener takes the agent's name, and the mood
   */
  public void whenShown(BiConsumer<String, Mood> listener) {
    tell(
        () -> {
          moods.forEach(listener);
          watchers.add(listener);
        });
  }

  /**
   * Has the listener told, on this agent's thread, of each answer to a question of a script from
   * now on.
   */
  public void whenAnswered(Consumer<GivenAnswer> listener) {
    tell(() -> clerks.add(listener));
  }

  private void given(GivenAnswer answer, ACLMessage message) {
    clerks.forEach(clerk -> clerk.accept(answer));
    answers.keep(answer, () -> tell(() -> confirm(message, answer.part())));
  }

  private void shown(String agent, Mood mood) {
    moods.put(agent, mood);
    watchers.forEach(watcher -> watcher.accept(agent, mood));
  }

  private void said(Speech speech) {
    recent.addLast(speech);
    if (recent.size() > SPEECHES_KEPT) {
      recent.removeFirst();
    }
    listeners.forEach(listener -> listener.accept(speech));
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      Optional<Speech> speech = SpeechWords.read(content);
      Optional<Mood> mood = SpeechWords.mood(content);
      Optional<GivenAnswer> answer = SpeechWords.given(content);
      boolean isForPeople = speech.isPresent() || mood.isPresent() || answer.isPresent();
      if (isForPeople && !mayTellPeople(Caller.of(message))) {
        refuse(
            message,
            ACLMessage.REFUSE,
            "%s stands for nothing in this home and tells people nothing; state goals to the CCA."
                .formatted(Caller.of(message)));
      } else if (speech.isPresent()) {
        said(speech.get());
        confirm(message, speech.get().part());
      } else if (mood.isPresent()) {
        shown(message.getSender().getLocalName(), mood.get());
        confirm(message, mood.get().part());
      } else if (answer.isPresent()) {
        given(answer.get(), message);
      } else {
        protest(message);
      }
    }
  }

  /** What people hear, and what was answered, is told by those who pursue goals alone (A23). */
  private boolean mayTellPeople(Caller caller) {
    return spokesmen.isOwn(caller);
  }

  private void confirm(ACLMessage message, String part) {
    reply(
        message, ACLMessage.INFORM, Words.content("inform", Words.named("said", Words.name(part))));
  }

  private void protest(ACLMessage message) {
    refuse(
        message,
        ACLMessage.NOT_UNDERSTOOD,
        "The desk answers no questions, and tells people what others say by (inform (:say \"...\")"
            + " (:to Bob) (:part G7.2)); state goals to the CCA by request.");
  }

  /** Whether nothing more follows in the conversation. */
  public static boolean isEnd(ACLMessage reply) {
    return Conversations.isFinal(reply);
  }

  /** Who waits for its answer is told so. */
  @Override
  public void agentDied(String agent) {
    tell(() -> conversations().partnerEnded(agent, getAMS()));
  }

  /**
   * States a goal; AGREE brings its id, the last reply how it ended. Of a held goal CONFIRM and
   * DISCONFIRM tell between them that it is so, and that it is not.
   */
  public void requestGoal(Formula goal, Consumer<ACLMessage> replies) {
    requestGoal(Words.content("initCNP", Words.named("goal", Words.formula(goal))), replies);
  }

  private void requestGoal(Content asked, Consumer<ACLMessage> replies) {
    request(ACLMessage.REQUEST, AgentNames.COORDINATOR, NO_END, replies, asked);
  }

  /**
   * States a goal. The report comes once, at the end, on this agent's thread; of a held goal, which
   * ends when it is cancelled, its story tells how it fares.
   *
   * @param accepted is told the goal's id as soon as the CCA has it; not called when it refuses
   */
  public void pursue(Formula goal, Consumer<String> accepted, Consumer<GoalReport> ended) {
    requestGoal(goal, reply -> tell(reply, accepted, ended));
  }

  /** The same, of a goal of which more is said. */
  public void pursue(AskedGoal goal, Consumer<String> accepted, Consumer<GoalReport> ended) {
    requestGoal(goal.content(), reply -> tell(reply, accepted, ended));
  }

  private static void tell(
      ACLMessage reply, Consumer<String> accepted, Consumer<GoalReport> ended) {
    if (reply.getPerformative() == ACLMessage.AGREE) {
      accepted.accept(GoalReport.acceptedId(reply.getContent()));
    } else if (isEnd(reply)) {
      ended.accept(GoalReport.read(reply.getContent()));
    }
  }

  /**
   * States a goal that is to be held.
   *
   * @param told each time that it begins or ceases to be so, and when it was found that it cannot
   *     be
   */
  public void hold(Formula goal, Consumer<HeldReport> told) {
    requestGoal(
        goal,
        reply -> {
          int performative = reply.getPerformative();
          if (performative == ACLMessage.CONFIRM || performative == ACLMessage.DISCONFIRM) {
            told.accept(HeldReport.read(performative == ACLMessage.CONFIRM, reply.getContent()));
          }
        });
  }

  /**
   * Says something for a person, to the agent that hears in her room, if one does and is there,
   * else to the central agent. What becomes of it is told once at first, and, where goals are taken
   * on, once when they are over, on this agent's thread.
   */
  public void say(Utterance utterance, Consumer<SaidReply> told) {
    List<String> agents = new ArrayList<>();
    agentByRoom.apply(utterance.room()).ifPresent(agents::add);
    agents.add(AgentNames.COORDINATOR);
    requestOfFirst(
        agents,
        reply -> {
          if (reply.getPerformative() == ACLMessage.AGREE || isEnd(reply)) {
            told.accept(SayWords.read(Words.parse(reply.getContent())));
          }
        },
        SayWords.content(utterance));
  }

  /**
   * Asks the agents of rooms who of them understands something.
   *
   * @param told the final reply, on this agent's thread
   */
  public void whoUnderstands(Utterance utterance, Consumer<ACLMessage> told) {
    request(
        ACLMessage.REQUEST,
        agentByRoom.apply(utterance.room()).orElse(AgentNames.COORDINATOR),
        NO_END,
        told,
        SayWords.asking(utterance));
  }

  /**
   * States a goal that somebody said in a room: to the central agent, or, while there is none, to
   * the agent of that room, if it has one.
   */
  public void state(AskedGoal goal, String room, Consumer<ACLMessage> replies) {
    List<String> agents = new ArrayList<>(List.of(AgentNames.COORDINATOR));
    agentByRoom.apply(room).ifPresent(agents::add);
    requestOfFirst(agents, replies, goal.content());
  }

  /** Asks the first of some agents that is there. */
  private void requestOfFirst(List<String> agents, Consumer<ACLMessage> replies, Content content) {
    tell(() -> askFirst(agents, replies, content));
  }

  private void askFirst(List<String> agents, Consumer<ACLMessage> replies, Content content) {
    String first = agents.get(0);
    boolean[] isHeard = {false};
    ask(
        message(ACLMessage.REQUEST, aid(first), content),
        NO_END,
        reply -> {
          if (!Replies.isFromPlatform(reply)) {
            isHeard[0] = true;
            replies.accept(reply);
          } else if (isHeard[0] || agents.size() == 1) {
            replies.accept(absent(first));
          } else {
            askFirst(agents.subList(1, agents.size()), replies, content);
          }
        });
  }

  /**
   * Tells words that a person has said so far, and after which others are to come; what she says in
   * the end is told by {@link #say}.
   *
   * @param told once, on this agent's thread
   */
  public void overhear(Utterance words, Consumer<OverheardReply> told) {
    request(
        ACLMessage.REQUEST,
        AgentNames.COORDINATOR,
        NO_END,
        reply -> told.accept(OverheardReply.read(reply.getContent())),
        SayWords.unfinished(agentByRoom.apply(words.room()).map(words::heardBy).orElse(words)));
  }

  /** Asks an agent of this platform; exactly one final reply follows. */
  public void request(
      int performative,
      String agent,
      Duration timeout,
      Consumer<ACLMessage> replies,
      Content... contents) {
    tell(
        () ->
            ask(
                message(performative, aid(agent), contents),
                timeout,
                reply -> replies.accept(Replies.isFromPlatform(reply) ? absent(agent) : reply)));
  }

  /**
   * Orders an agent of this platform to do something; exactly one final reply follows.
   *
   * @return calls it off, after which the final reply follows all the same
   */
  public Runnable order(
      String agent, Duration timeout, Consumer<ACLMessage> replies, Content order) {
    Order given = new Order(aid(agent));
    tell(
        () ->
            given.conversation =
                conversations()
                    .ask(
                        message(ACLMessage.REQUEST, given.agent, order),
                        patience(timeout),
                        reply ->
                            replies.accept(Replies.isFromPlatform(reply) ? absent(agent) : reply)));
    return () -> tell(() -> callOff(given));
  }

  /** An order under way. For this agent's thread. */
  private static final class Order {
    private final AID agent;
    private String conversation = "";

    Order(AID agent) {
      this.agent = agent;
    }
  }

  private void callOff(Order order) {
    ACLMessage cancel =
        message(
            ACLMessage.CANCEL,
            order.agent,
            Words.content("cancel", Words.named("order", Words.text(order.conversation))));
    cancel.setConversationId(order.conversation);
    send(cancel);
  }

  /**
   * Asks an agent of another platform; exactly one final reply follows. What cannot be delivered is
   * a FAILURE in the platform's words.
   */
  public void request(
      int performative,
      OtherPlatform platform,
      String agent,
      Duration timeout,
      Consumer<ACLMessage> replies,
      Content... contents) {
    tell(
        () ->
            ask(
                message(performative, platform.agent(agent), contents),
                timeout,
                reply ->
                    replies.accept(
                        Replies.isFromPlatform(reply) ? unreachable(platform, agent) : reply)));
  }

  private static ACLMessage unreachable(OtherPlatform platform, String agent) {
    return failure(
        "The agent %s of the platform %s cannot be reached at %s; see that it runs there with --mtp and has that name, and that this platform runs with --mtp too."
            .formatted(agent, platform.name(), platform.url()));
  }

  /** What the platform says in its own words, in ours. */
  private static ACLMessage absent(String agent) {
    return failure(
        agent.equals(AgentNames.COORDINATOR)
            ? "There is no central coordination agent (CCA) now: it was ended;"
                + " what runs goes on, and ./maestro revive starts it again."
            : "There is no agent named "
                + agent
                + " on this platform; ./maestro agents lists those there are.");
  }

  private static ACLMessage failure(String reason) {
    ACLMessage failure = new ACLMessage(ACLMessage.FAILURE);
    failure.setLanguage(Words.LANGUAGE);
    failure.setContent(
        Words.print(Words.content("inform", Words.named("reason", Words.text(reason)))));
    return failure;
  }

  /** Listens to a goal's story, from its beginning. */
  public void follow(String goalId, Consumer<ACLMessage> lines) {
    tell(() -> follow(aid(AgentNames.COORDINATOR), goalId, lines));
  }

  /** The same of a goal of another platform. */
  public void follow(OtherPlatform platform, String goalId, Consumer<ACLMessage> lines) {
    tell(() -> follow(platform.agent(AgentNames.COORDINATOR), goalId, lines));
  }

  private void follow(AID centre, String goalId, Consumer<ACLMessage> lines) {
    conversations()
        .subscribe(
            message(
                ACLMessage.SUBSCRIBE,
                centre,
                Words.content("subscribe", Words.named("story", Words.name(goalId)))),
            lines);
  }

  /**
   * Reads the collective knowledge: at once when this was read before, as the desk is told what
   * changes.
   *
   * @param answers in the words of the knowledge agent; told once
   * @param failure told instead, one sentence
   */
  public void know(Formula question, Consumer<List<Content>> answers, Consumer<String> failure) {
    know(question, Optional.empty(), answers, failure);
  }

  /**
   * The same for a person: what is private is told her only where she may read it.
   *
   * @param person who has signed in at this desk; empty: nobody in particular
   */
  public void know(
      Formula question,
      Optional<String> person,
      Consumer<List<Content>> answers,
      Consumer<String> failure) {
    tell(() -> knowledge.read(question, person, known -> told(known, answers, failure)));
  }

  /** The same, and again whenever the answer changes. */
  public void follow(Formula question, Consumer<List<Content>> answers, Consumer<String> failure) {
    tell(() -> knowledge.follow(question, known -> told(known, answers, failure)));
  }

  private static void told(
      KnowledgeCache.Known known, Consumer<List<Content>> answers, Consumer<String> failure) {
    if (known.isFailure()) {
      failure.accept(known.failure());
    } else {
      answers.accept(
          known.answers().stream().map(one -> BeliefWords.later(one, known.since())).toList());
    }
  }

  private AID aid(String localName) {
    return getAID(localName);
  }
}
