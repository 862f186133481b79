package org.maestro.console.api;

import static org.maestro.console.api.Operation.asking;
import static org.maestro.console.api.Operation.get;
import static org.maestro.console.api.Operation.order;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.AskedStakes;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation.Method;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.api.Operation.Request;
import org.maestro.console.documents.FactsDocument;
import org.maestro.console.documents.HistoryDocument;
import org.maestro.console.documents.HomeDocument;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.AgentOrder;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.references.ReferenceGraph;
import org.maestro.console.references.ReferencesDocument;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.rats.security.Role;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/** The operations that a platform offers to programs, and to the page. */
public final class Api {
  /** Below this are all operations of this version. */
  public static final String ROOT = "/api/v1";

  private static final int CREATED = 201;
  static final Parameter GOAL = Parameter.path("goal", "A goal's id, such as G1.");

  private static final Parameter AGENT = Parameter.path("agent", "An agent's name.");

  private final String platform;
  private final double speed;
  private final boolean simulated;
  private final AclQuestions questions;
  private final KnowledgeBase knowledge;
  private final Readership readership;
  private final Function<String, CompletableFuture<JsonNode>> preview;
  private final Function<String, CompletableFuture<JsonNode>> queries;

  /**
   * @param platform its name
   * @param speed of its clock, simulated seconds in one of wall time
   * @param simulated whether this process simulates the home
   * @param readership who may read what of all that is known
   * @param preview makes a plan for a goal that is not stated yet
   * @param queries answers SPARQL
   */
  public Api(
      String platform,
      double speed,
      boolean simulated,
      AclQuestions questions,
      KnowledgeBase knowledge,
      Readership readership,
      Function<String, CompletableFuture<JsonNode>> preview,
      Function<String, CompletableFuture<JsonNode>> queries) {
    this.platform = platform;
    this.speed = speed;
    this.simulated = simulated;
    this.questions = questions;
    this.knowledge = knowledge;
    this.readership = readership;
    this.preview = preview;
    this.queries = queries;
  }

  public List<Operation> operations() {
    return List.of(
        get(
            "/platform",
            "platform",
            "The platform: its name, and the home that it runs.",
            "platform",
            request -> answer(platform())),
        get(
            "/home",
            "home",
            "The home as it can be drawn: rooms, zones, doors, things, devices.",
            "home",
            request -> answer(HomeDocument.of(knowledge.home()))),
        get(
            "/facts",
            "facts",
            "All that is known now, each fact with its source, age and confidence.",
            "facts",
            request ->
                answer(FactsDocument.of(knowledge.snapshot(), readership.of(request.visit())))),
        get(
            "/goals",
            "goals",
            "The goals, in the order in which they were stated.",
            "goals",
            request -> questions.of(readership.name(request.visit())).goals()),
        order(Method.POST, "/goals", "stateGoal", "States a goal.", this::state)
            .taking("goal-request")
            .answering(CREATED, "goal-accepted"),
        asking(
                Method.POST,
                "/previews",
                "previewGoal",
                "The plan for a goal and its price as described, before anybody is asked.",
                "preview",
                this::preview)
            .taking("preview-request"),
        order(
                Method.DELETE,
                "/goals/{goal}",
                "cancelGoal",
                "Gives a goal up; what runs for it ends by its exit strategy.",
                request -> questions.cancel(request.parameter("goal"), request.visit().person()))
            .with(GOAL),
        order(
                Method.POST,
                "/questions/{question}/answer",
                "answerQuestion",
                "Answers a question of a script; what is not what it asks for leaves it open.",
                request ->
                    questions.answer(
                        request.parameter("question"),
                        request.body().path("text").asText(),
                        request.visit().person(),
                        text(request.body(), "person")))
            .with(Parameter.path("question", "The part of a script that asks, such as G1.2."))
            .taking("answer-request"),
        get(
                "/goals/{goal}/story",
                "story",
                "A goal's story; with a step, why its member does that step and not another.",
                "why",
                this::story)
            .with(
                GOAL,
                Parameter.number("step", "The number of a step."),
                Parameter.number("plan", "Of which plan; without: of the latest.")),
        get(
            "/agents",
            "agents",
            "The agents, and the members that they stand for.",
            "agents",
            request -> questions.agents()),
        asking(
                Method.POST,
                "/agents",
                "addAgents",
                "Starts an agent for each device that a description has, or one for all of them, and the agents of rooms.",
                "told",
                this::add)
            .by(Role.ADMINISTRATOR)
            .taking("agent-request")
            .answering(CREATED, "told"),
        asking(
                Method.POST,
                "/agents/{agent}/moves",
                "moveAgent",
                "Has an agent live in another container; it goes when nothing is under way.",
                "told",
                request ->
                    questions.order(
                        new AgentOrder.Move(
                            request.parameter("agent"), request.body().path("to").asText())))
            .by(Role.ADMINISTRATOR)
            .with(AGENT)
            .taking("agent-move"),
        asking(
                Method.POST,
                "/agents/{agent}/descriptions",
                "reconfigureAgent",
                "Has an agent go by another description of its device.",
                "told",
                request ->
                    questions.order(
                        new AgentOrder.Reconfigure(
                            request.parameter("agent"),
                            request.body().path("description").asText(),
                            request.body().path("file").asText("description"))))
            .by(Role.ADMINISTRATOR)
            .with(AGENT)
            .taking("agent-description"),
        asking(
                Method.DELETE,
                "/agents/{agent}",
                "removeAgent",
                "Ends an agent; its device gets no other until one is added.",
                "told",
                request -> questions.order(new AgentOrder.Remove(request.parameter("agent"))))
            .by(Role.ADMINISTRATOR)
            .with(AGENT),
        get(
            "/references",
            "references",
            "What the running agents are for, and which refers to which and why.",
            "agents-diagram",
            request -> questions.agents().thenApply(this::references)),
        get(
            "/containers",
            "containers",
            "The containers, with the agents of each.",
            "agents-containers",
            request -> questions.containers()),
        get(
            "/words",
            "words",
            "The words in which goals and questions can be put.",
            "words",
            request -> questions.words()),
        get(
                "/knowledge",
                "know",
                "What is known of a question, how surely, and how old that is.",
                "know",
                request -> questions.know(request.parameter("question"), request.visit().person()))
            .with(
                Parameter.query(
                    "question", "In MAESTRO-SL, perhaps with variables: (in Cup ?where).")),
        get(
                "/knowledge/history",
                "history",
                "Who said what of something, oldest first: what was replaced and what has lost, too.",
                "history",
                this::history)
            .with(Parameter.query("fact", "In MAESTRO-SL: (in Cup zone-a), (illuminance zone-a).")),
        asking(
                Method.POST,
                "/queries",
                "query",
                "What a SPARQL SELECT finds in all that is known, 1,000 rows at most.",
                "rows",
                this::query)
            .taking("query-request"),
        order(
                Method.POST,
                "/safe-state",
                "stop",
                "Brings every device into a safe state, now; the platform stays.",
                request -> questions.stop(Optional.empty()))
            .atOnce(),
        order(
                Method.POST,
                "/coordinator/revival",
                "revive",
                "Starts the central coordination agent again after it was ended.",
                request -> questions.revive())
            .by(Role.ADMINISTRATOR));
  }

  private JsonNode platform() {
    return JsonMembers.empty()
        .text("platform", platform)
        .text("home", knowledge.home().label())
        .number("speed", speed)
        .truth("simulated", simulated)
        .number("devices", OptionalInt.of(knowledge.home().devices().size()))
        .node();
  }

  private JsonNode references(JsonNode agents) {
    return ReferencesDocument.of(
        new ReferenceGraph(agents, knowledge.home(), knowledge.snapshot()));
  }

  private CompletableFuture<JsonNode> history(Request request) {
    String fact = request.parameter("fact");
    try {
      Optional<String> objection = readership.of(request.visit()).objectionToFact(fact);
      return objection.isPresent()
          ? CompletableFuture.failedFuture(RefusalException.badInput(objection.get()))
          : answer(HistoryDocument.of(knowledge.history(fact), knowledge.snapshot()));
    } catch (KnowledgeException | SlSyntaxException e) {
      return CompletableFuture.failedFuture(
          RefusalException.badInput(String.valueOf(e.getMessage())));
    }
  }

  /** A query may look at everything, so that who may not is not let look at all. */
  private CompletableFuture<JsonNode> query(Request request) {
    ReadingRights rights = readership.of(request.visit());
    Optional<String> objection = rights.objection(rights.hidden());
    return objection.isPresent()
        ? CompletableFuture.failedFuture(
            RefusalException.badInput(
                objection.get() + " A query in SPARQL reads everything; ask in MAESTRO-SL."))
        : queries.apply(request.body().path("query").asText());
  }

  /** A plan may be as it is because of what is private. */
  private CompletableFuture<JsonNode> preview(Request request) {
    String goal = request.body().path("goal").asText();
    Optional<String> objection;
    try {
      objection = readership.of(request.visit()).objection(SlParser.formula(goal));
    } catch (SlSyntaxException e) {
      return CompletableFuture.failedFuture(
          RefusalException.badInput(String.valueOf(e.getMessage())));
    }
    return objection.isPresent()
        ? CompletableFuture.failedFuture(RefusalException.badInput(objection.get()))
        : preview.apply(goal);
  }

  private CompletableFuture<JsonNode> state(Request request) {
    JsonNode asked = request.body();
    return questions
        .state(
            new AskedGoal(asked.path("goal").asText())
                .priority(asked.path("priority").asInt())
                .deadlineSeconds(number(asked, "deadline_s"))
                .stakes(stakes(asked))
                .person(request.visit().person()))
        .thenApply(id -> JsonMembers.empty().text("id", id).node());
  }

  private CompletableFuture<JsonNode> add(Request request) {
    JsonNode asked = request.body();
    List<String> needs = new ArrayList<>();
    asked.path("needs").forEach(need -> needs.add(need.asText()));
    return questions.order(
        new AgentOrder.Add(
            asked.path("description").asText(),
            asked.path("file").asText("description"),
            text(asked, "as"),
            text(asked, "container"),
            needs));
  }

  private static AskedStakes stakes(JsonNode asked) {
    return new AskedStakes(
        Optional.of(asked.path("benefit"))
            .filter(benefit -> !benefit.isMissingNode() && !benefit.isNull())
            .map(JsonNode::asText),
        number(asked, "chance"),
        number(asked, "allowed_s"),
        number(asked, "urgency_from"),
        number(asked, "urgency_to"));
  }

  private static Optional<Double> number(JsonNode asked, String name) {
    return Optional.of(asked.path(name)).filter(JsonNode::isNumber).map(JsonNode::asDouble);
  }

  private static Optional<String> text(JsonNode asked, String name) {
    return Optional.ofNullable(asked.path(name).textValue()).filter(text -> !text.isBlank());
  }

  private CompletableFuture<JsonNode> story(Request request) {
    OptionalInt step = request.number("step");
    OptionalInt plan = request.number("plan");
    if (plan.isPresent() && step.isEmpty()) {
      return CompletableFuture.failedFuture(
          RefusalException.badInput("plan says of which plan the step is; add step."));
    }
    return questions
        .of(readership.name(request.visit()))
        .story(request.parameter("goal"), plan, step);
  }

  private static CompletableFuture<JsonNode> answer(JsonNode document) {
    return CompletableFuture.completedFuture(document);
  }
}
