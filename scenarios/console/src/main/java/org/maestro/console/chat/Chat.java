package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;
import org.maestro.console.api.Operation;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.traffic.Ring;
import org.maestro.console.traffic.Source;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.language.Language;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.validation.Nearest;
import org.maestro.rats.security.Role;

/**
 * The conversations, one for each person of the home: what is said is handed to who answers her,
 * and all that is said by either is kept for who looks at it, the latest of it. Any thread may use
 * it.
 */
public final class Chat implements Source {
  private static final int CREATED = 201;
  private static final int MOST = 2_000;
  private static final long HEAVIEST = 2_000_000;
  private static final int MOST_CHARACTERS = 2_000;
  private static final String PERSON = "Person";
  private static final String ROOM = "Room";

  private final Supplier<Home> home;
  private final Supplier<Interlocutor> partners;
  private final Answering answering;
  private final AskedQuestions asked = new AskedQuestions();
  private final InstantSource wall;
  private final Ring<ChatEntry> entries = new Ring<>(MOST, HEAVIEST);
  private final Map<String, Interlocutor> partnerByPerson = new TreeMap<>();

  /**
   * @param home as it is known at the time
   * @param partners makes who answers a person
   * @param answering where answers to questions of scripts go
   */
  public Chat(
      Supplier<Home> home,
      Supplier<Interlocutor> partners,
      Answering answering,
      InstantSource wall) {
    this.home = home;
    this.partners = partners;
    this.answering = answering;
    this.wall = wall;
  }

  public List<Operation> operations() {
    return List.of(
        Operation.asking(
                Operation.Method.POST,
                "/chat",
                "say",
                "Says something as a person of the home; what becomes of it is told as it happens.",
                "chat-accepted",
                request -> CompletableFuture.completedFuture(say(read(request))))
            .by(Role.OPERATOR)
            .taking("chat-request")
            .answering(CREATED, "chat-accepted"),
        Operation.get(
            "/chat",
            "chat",
            "What was said lately, by whom in which room, and what became of it.",
            "chat",
            request -> CompletableFuture.completedFuture(all())));
  }

  private Utterance read(Operation.Request request) {
    JsonNode body = request.body();
    if (body.path("text").asText().length() > MOST_CHARACTERS) {
      throw RefusalException.badInput(
          "That is longer than %d characters; say less at once.".formatted(MOST_CHARACTERS));
    }
    return new Utterance(
        known(body.path("person").asText(), PERSON, "person"),
        known(body.path("room").asText(), ROOM, "room"),
        body.path("text").asText(),
        request.visit().person(),
        spoken(body.path("language").asText("")));
  }

  private static Optional<String> spoken(String tag) {
    if (!tag.isEmpty() && !Language.isShipped(tag)) {
      throw RefusalException.badInput(
          "Nobody here understands the language %s; say it in one that is shipped, such as de."
              .formatted(tag));
    }
    return Optional.of(tag).filter(one -> !one.isEmpty());
  }

  private String known(String name, String className, String what) {
    List<String> names = names(className);
    if (!names.contains(name)) {
      throw RefusalException.badInput(
          "This home has no %s %s; %s."
              .formatted(
                  what,
                  name,
                  Nearest.cure(
                      name,
                      names,
                      names.isEmpty() ? "give it one" : "it has " + String.join(", ", names))));
    }
    return name;
  }

  private List<String> names(String className) {
    return home.get().individuals().values().stream()
        .filter(one -> one.classes().contains(className))
        .map(Individual::name)
        .toList();
  }

  /** Hands it over; returned is the number under which it is kept. */
  private JsonNode say(Utterance utterance) {
    long number = add(ChatEntry.said(utterance, wall.instant()));
    Optional<Speech> question = asked.of(utterance).filter(speech -> mayAnswer(utterance.text()));
    question.ifPresentOrElse(speech -> answer(speech, utterance), () -> understand(utterance));
    return JsonNodeFactory.instance.objectNode().put("number", number);
  }

  /** What is written as a goal or a question is one. */
  private static boolean mayAnswer(String text) {
    return !text.strip().startsWith("(") && !text.strip().startsWith("?");
  }

  private void answer(Speech question, Utterance utterance) {
    answering
        .answer(question.part(), utterance.text(), utterance.asker())
        .thenAccept(done -> answered(question, utterance))
        .exceptionally(
            failure -> {
              refused(question, utterance, failure);
              return null;
            });
  }

  private void answered(Speech question, Utterance utterance) {
    asked.over(question);
    tell(
        utterance,
        new ChatEvent.Told(question.goalId(), "That is the answer to: " + question.text()));
  }

  private void refused(Speech question, Utterance utterance, Throwable failure) {
    Throwable refusal =
        failure instanceof CompletionException && failure.getCause() != null
            ? failure.getCause()
            : failure;
    if (refusal instanceof RefusalException none
        && none.kind() == RefusalException.Kind.NOT_THERE) {
      asked.over(question);
      understand(utterance);
    } else {
      tell(
          utterance,
          new ChatEvent.Misunderstood(
              String.valueOf(refusal.getMessage()),
              question.wanted().map(Speech.Wanted::choices).orElse(List.of())));
    }
  }

  private void understand(Utterance utterance) {
    partner(utterance.person()).hear(utterance, event -> tell(utterance, event));
  }

  private void tell(Utterance utterance, ChatEvent event) {
    add(ChatEntry.of(event, utterance, wall.instant()));
  }

  /**
   * Somebody who is no person says something to one, or in a room. What she says next, or who is in
   * the room, is the answer to a question.
   */
  public void hear(Speech speech) {
    if (speech.wanted().isPresent()) {
      asked.asked(speech);
    }
    boolean isForOne = names(PERSON).contains(speech.to());
    add(
        ChatEntry.spoken(
            speech, isForOne ? speech.to() : "", isForOne ? "" : speech.to(), wall.instant()));
  }

  /** An agent shows a mood, to all who look. */
  public void see(String agent, Mood mood) {
    add(ChatEntry.shown(agent, mood, wall.instant()));
  }

  private synchronized Interlocutor partner(String person) {
    return partnerByPerson.computeIfAbsent(person, name -> partners.get());
  }

  private long add(ChatEntry entry) {
    return entries.add(entry, entry.weight());
  }

  @Override
  public long latest() {
    return entries.latest();
  }

  @Override
  public JsonNode between(long after, long last) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode array = document.node().putArray("entries");
    for (Ring.Kept<ChatEntry> kept : entries.between(after, last)) {
      ChatEntry entry = kept.what();
      JsonMembers row = JsonMembers.in(array);
      row.node().put("number", kept.number());
      row.text("at", entry.at().toString())
          .text("person", entry.person())
          .text("room", entry.room())
          .text("kind", entry.kind())
          .text("goal", entry.goal())
          .text("question", entry.question());
      row.node().put("text", ShownText.of(entry.text()));
      row.words("near", entry.near().stream().map(ShownText::of).toList());
    }
    return document.node();
  }
}
