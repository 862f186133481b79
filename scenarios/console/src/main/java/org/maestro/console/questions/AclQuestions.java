package org.maestro.console.questions;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.SpeechWords;
import org.maestro.agents.content.Words;
import org.maestro.console.documents.AgentsDocument;
import org.maestro.console.documents.AnswersDocument;
import org.maestro.console.documents.BidsDocument;
import org.maestro.console.documents.ContainersDocument;
import org.maestro.console.documents.GoalsDocument;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.PlansDocument;
import org.maestro.console.documents.StoryDocument;
import org.maestro.console.documents.WordsDocument;
import org.maestro.dialogue.Utterance;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/** Asks the agents of a platform by messages from a desk. */
public final class AclQuestions implements Questions {
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(20);

  private final DeskAgent desk;
  private final Predicate<String> shownContainers;
  private final Optional<String> reader;

  public AclQuestions(DeskAgent desk) {
    this(desk, container -> true);
  }

  /**
   * @param shownContainers of whose agents is told, by name; one that is there to ask only is not
   */
  public AclQuestions(DeskAgent desk, Predicate<String> shownContainers) {
    this(desk, shownContainers, Optional.empty());
  }

  private AclQuestions(DeskAgent desk, Predicate<String> shownContainers, Optional<String> reader) {
    this.desk = desk;
    this.shownContainers = shownContainers;
    this.reader = reader;
  }

  /**
   * The same as somebody asks them who is told of private goals only what she may read.
   *
   * @param person who has signed in at the desk; empty: whoever is there
   */
  public AclQuestions of(Optional<String> person) {
    return new AclQuestions(desk, shownContainers, person);
  }

  @Override
  public CompletableFuture<JsonNode> goals() {
    return ask(ACLMessage.QUERY_REF, AgentNames.COORDINATOR, read("query-ref", List.of()))
        .thenApply(GoalsDocument::of);
  }

  @Override
  public CompletableFuture<JsonNode> agents() {
    return tables().thenApply(lines -> AgentsDocument.of(lines, shownContainers));
  }

  @Override
  public CompletableFuture<JsonNode> containers() {
    return tables().thenApply(lines -> ContainersDocument.of(lines, shownContainers));
  }

  @Override
  public CompletableFuture<JsonNode> references() {
    return CompletableFuture.failedFuture(
        RefusalException.outside(
            "Which agent refers to which is told by the console, which does not answer here; run the platform with one (without --console off), or list the agents: ./maestro agents"));
  }

  private CompletableFuture<List<Words>> tables() {
    return ask(ACLMessage.QUERY_REF, AgentNames.SUPERVISOR, Words.content("query-ref"));
  }

  @Override
  public CompletableFuture<JsonNode> words() {
    return ask(
            ACLMessage.QUERY_REF,
            AgentNames.KNOWLEDGE,
            Words.content("query-ref", Words.named("words", List.of())))
        .thenApply(WordsDocument::ofAnswer);
  }

  @Override
  public CompletableFuture<JsonNode> know(String question) {
    return know(question, Optional.empty());
  }

  /**
   * The same for a person, who is told what is private only where she may read it.
   *
   * @param person who has signed in at the desk
   */
  public CompletableFuture<JsonNode> know(String question, Optional<String> person) {
    CompletableFuture<JsonNode> answer = new CompletableFuture<>();
    Formula asked;
    try {
      asked = SlParser.formula(question);
    } catch (SlSyntaxException e) {
      answer.completeExceptionally(RefusalException.badInput(String.valueOf(e.getMessage())));
      return answer;
    }
    desk.know(
        asked,
        person,
        contents -> answer.complete(AnswersDocument.of(contents.stream().map(Words::of).toList())),
        failure -> answer.completeExceptionally(RefusalException.badInput(failure)));
    return answer;
  }

  @Override
  public CompletableFuture<JsonNode> story(String goal, OptionalInt plan, OptionalInt step) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("goal", Words.name(goal)));
    plan.ifPresent(number -> arguments.add(Words.named("plan", Words.number(number))));
    step.ifPresent(number -> arguments.add(Words.named("step", Words.number(number))));
    return ask(ACLMessage.REQUEST, AgentNames.COORDINATOR, read("explain", arguments))
        .thenApply(lines -> StoryDocument.of(goal, lines.stream().map(Reply::story).toList()));
  }

  /** The plans that were made for a goal, and what has become of their steps. */
  public CompletableFuture<ObjectNode> plans(String goal) {
    return ask(
            ACLMessage.QUERY_REF,
            AgentNames.COORDINATOR,
            read("query-ref", List.of(Words.named("plans", Words.name(goal)))))
        .thenApply(lines -> PlansDocument.of(goal, lines));
  }

  /**
   * Who was asked when a plan was made, and what was answered.
   *
   * @param plan its number; empty: the latest
   */
  public CompletableFuture<JsonNode> bids(String goal, OptionalInt plan) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("bids", Words.name(goal)));
    plan.ifPresent(number -> arguments.add(Words.named("plan", Words.number(number))));
    return ask(ACLMessage.QUERY_REF, AgentNames.COORDINATOR, read("query-ref", arguments))
        .thenApply(lines -> BidsDocument.of(goal, plan, lines));
  }

  private Content read(String operator, List<Content.Argument> arguments) {
    List<Content.Argument> all = new ArrayList<>(arguments);
    reader.ifPresent(name -> all.add(Words.named("for", Words.text(name))));
    return new Content(operator, all);
  }

  @Override
  public CompletableFuture<JsonNode> trace(String goal) {
    return CompletableFuture.failedFuture(
        RefusalException.outside(
            "What is said for a goal is kept by the console, which does not answer here; run the platform with one (without --console off), or ask for the story: ./maestro why "
                + goal));
  }

  @Override
  public CompletableFuture<JsonNode> say(
      String person, String room, String text, Optional<String> language) {
    return heardByTheConsole();
  }

  @Override
  public CompletableFuture<JsonNode> hear(String person, String room, String text, boolean more) {
    return heardByTheConsole();
  }

  /**
   * Tells the central agent words as they are heard.
   *
   * @param words all of the sentence so far
   * @param more whether others are to come
   */
  public CompletableFuture<JsonNode> hear(Utterance words, boolean more) {
    CompletableFuture<JsonNode> answer = new CompletableFuture<>();
    if (more) {
      desk.overhear(words, reply -> answer.complete(HeardDocument.of(desk.clock().now(), reply)));
    } else {
      desk.say(words, reply -> answer.complete(HeardDocument.of(desk.clock().now(), reply)));
    }
    return answer;
  }

  @Override
  public CompletableFuture<JsonNode> said(long after) {
    return heardByTheConsole();
  }

  @Override
  public CompletableFuture<JsonNode> nextWords(String person, String room, String text) {
    return heardByTheConsole();
  }

  private static CompletableFuture<JsonNode> heardByTheConsole() {
    return CompletableFuture.failedFuture(
        RefusalException.outside(
            "What people say is heard by the console, which does not answer here; run the platform"
                + " with one (without --console off), or state a goal: ./maestro goal."));
  }

  @Override
  public CompletableFuture<Void> cancel(String goal) {
    return cancel(goal, Optional.empty());
  }

  /**
   * The same for a person, of whom the goal's story tells.
   *
   * @param person who has signed in at the desk
   */
  public CompletableFuture<Void> cancel(String goal, Optional<String> person) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("goal", Words.name(goal)));
    person.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    return ask(ACLMessage.REQUEST, AgentNames.COORDINATOR, new Content("cancel", arguments))
        .thenAccept(lines -> {});
  }

  /** What was so before a goal that is over. */
  public CompletableFuture<FormerState> before(String goal) {
    return ask(
            ACLMessage.QUERY_REF,
            AgentNames.COORDINATOR,
            read("query-ref", List.of(Words.named("before", Words.name(goal)))))
        .thenApply(lines -> FormerState.of(lines.get(0)));
  }

  @Override
  public CompletableFuture<Void> answer(String question, String text, Optional<String> person) {
    return answer(question, text, Optional.empty(), person);
  }

  /**
   * The same for who has signed in.
   *
   * @param user who has signed in at the desk
   */
  public CompletableFuture<Void> answer(
      String question, String text, Optional<String> user, Optional<String> person) {
    return ask(
            ACLMessage.REQUEST,
            AgentNames.COORDINATOR,
            SpeechWords.answer(question, text, user, person))
        .thenAccept(lines -> {});
  }

  @Override
  public CompletableFuture<JsonNode> answers(Optional<String> script) {
    return toldByTheConsole("Answers to scripts are");
  }

  @Override
  public CompletableFuture<JsonNode> day(String person, Optional<String> date) {
    return toldByTheConsole("Days of residents are");
  }

  private static CompletableFuture<JsonNode> toldByTheConsole(String what) {
    return CompletableFuture.failedFuture(
        RefusalException.outside(
            what
                + " told by the console, which does not answer here; run the platform with one"
                + " (without --console off)."));
  }

  @Override
  public CompletableFuture<JsonNode> order(AgentOrder order) {
    return ask(
            ACLMessage.REQUEST,
            AgentNames.COORDINATOR,
            new Content("perform", OrderWords.arguments(order)))
        .thenApply(
            lines ->
                JsonMembers.empty()
                    .words("told", lines.stream().flatMap(l -> l.string("text").stream()).toList())
                    .node());
  }

  @Override
  public CompletableFuture<Void> stop(Optional<String> member) {
    return order(
        "stop", member.map(name -> Words.named("member", Words.text(name))).stream().toList());
  }

  @Override
  public CompletableFuture<Void> revive() {
    return order("revive", List.of());
  }

  private CompletableFuture<Void> order(String action, List<Content.Argument.Named> of) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("action", Words.name(action)));
    arguments.addAll(of);
    return ask(ACLMessage.REQUEST, AgentNames.SUPERVISOR, new Content("perform", arguments))
        .thenAccept(lines -> {});
  }

  /**
   * States a goal; how it fares is told by its story.
   *
   * @return its id, as soon as it is accepted
   */
  public CompletableFuture<String> state(AskedGoal goal) {
    return state(goal, report -> {});
  }

  /**
   * The same.
   *
   * @param ended told once how a goal that was accepted has ended
   */
  public CompletableFuture<String> state(AskedGoal goal, Consumer<GoalReport> ended) {
    return state(goal, "", ended);
  }

  /**
   * The same of one that was said in a room, whose agent takes it on while there is no central one.
   *
   * @param room "" of none
   */
  public CompletableFuture<String> state(AskedGoal goal, String room, Consumer<GoalReport> ended) {
    CompletableFuture<String> accepted = new CompletableFuture<>();
    desk.state(
        goal,
        room,
        reply -> {
          if (reply.getPerformative() == ACLMessage.AGREE) {
            accepted.complete(Reply.words(reply).get(0).string("goal").orElse(""));
          } else if (DeskAgent.isEnd(reply) && accepted.isDone()) {
            ended.accept(GoalReport.read(reply.getContent()));
          } else if (DeskAgent.isEnd(reply)) {
            accepted.completeExceptionally(refusal(reply));
          }
        });
    return accepted;
  }

  /**
   * A room agent that understands something.
   *
   * @param laterSeconds what asking the others has taken
   */
  public record Understander(String agent, double laterSeconds) {}

  /** Which of the room agents understands it; refused where none does. */
  public CompletableFuture<Understander> whoUnderstands(Utterance utterance) {
    CompletableFuture<Understander> answer = new CompletableFuture<>();
    desk.whoUnderstands(
        utterance,
        reply -> {
          Optional<String> agent = Reply.words(reply).get(0).string("through");
          if (reply.getPerformative() == ACLMessage.INFORM && agent.isPresent()) {
            answer.complete(
                new Understander(agent.get(), Reply.words(reply).get(0).number("later", 0)));
          } else {
            answer.completeExceptionally(refusal(reply));
          }
        });
    return answer;
  }

  private static RefusalException refusal(ACLMessage reply) {
    List<Words> words = Reply.words(reply);
    return reply.getPerformative() == ACLMessage.FAILURE
        ? RefusalException.outside(Reply.reason(words))
        : Reply.refusal(words);
  }

  private CompletableFuture<List<Words>> ask(int performative, String agent, Content content) {
    CompletableFuture<List<Words>> answer = new CompletableFuture<>();
    desk.request(
        performative,
        agent,
        ANSWER_WITHIN,
        reply -> {
          if (DeskAgent.isEnd(reply)) {
            try {
              answer.complete(Reply.lines(reply));
            } catch (RuntimeException e) {
              answer.completeExceptionally(e);
            }
          }
        },
        content);
    return answer;
  }
}
