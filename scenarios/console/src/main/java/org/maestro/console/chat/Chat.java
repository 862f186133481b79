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
import java.util.function.Function;
import java.util.function.Supplier;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.documents.ShownText;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.traffic.Ring;
import org.maestro.console.traffic.Source;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Utterance;
import org.maestro.dialogue.UtteranceCheck;
import org.maestro.language.Language;
import org.maestro.ontology.home.Home;
import org.maestro.rats.security.Role;

/**
 * The conversations, one for each person of the home: what is said is handed to who answers her,
 * and all that is said by either is kept for who looks at it, the latest of it. Any thread may use
 * it.
 */
public final class Chat implements Source {
  private static final int CREATED = 201;
  private static final int MOST = 2_000;
  private static final int MOST_NEXT = 100;
  private static final long HEAVIEST = 2_000_000;

  private final Supplier<Home> home;
  private final Function<String, Interlocutor> partners;
  private final Answering answering;
  private final WordByWord hearing;
  private final Dialogues dialogues;
  private final Readership readership;
  private final InstantSource wall;
  private final Ring<ChatEntry> entries = new Ring<>(MOST, HEAVIEST);
  private final Map<String, Interlocutor> partnerByPerson = new TreeMap<>();

  /**
   * @param home as it is known at the time
   * @param partners makes who answers the person of that name
   * @param answering where answers to questions of scripts go
   * @param hearing where words go as they are heard
   * @param dialogues what persons have said before, and scripts have asked
   * @param readership who may read what is private
   */
  public Chat(
      Supplier<Home> home,
      Function<String, Interlocutor> partners,
      Answering answering,
      WordByWord hearing,
      Dialogues dialogues,
      Readership readership,
      InstantSource wall) {
    this.home = home;
    this.partners = partners;
    this.answering = answering;
    this.hearing = hearing;
    this.dialogues = dialogues;
    this.readership = readership;
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
        Operation.asking(
                Operation.Method.POST,
                "/chat/heard",
                "hear",
                "Tells words of a person as they are heard; what is certain is begun before the"
                    + " end.",
                "chat-heard",
                request -> hear(read(request), request.body().path("more").asBoolean(false)))
            .by(Role.OPERATOR)
            .taking("chat-heard-request"),
        Operation.get(
                "/chat",
                "chat",
                "What was said lately, by whom in which room, and what became of it.",
                "chat",
                request ->
                    CompletableFuture.completedFuture(
                        between(request.number("after").orElse(0), latest())))
            .with(
                Operation.Parameter.number(
                    "after", "Only what has a higher number; without, all that is kept.")),
        Operation.get(
                "/chat/words",
                "nextWords",
                "Words with which what a person writes could go on.",
                "chat-words",
                request -> CompletableFuture.completedFuture(next(request)))
            .with(
                Operation.Parameter.query("person", "Who writes."),
                Operation.Parameter.query("room", "In which room."),
                Operation.Parameter.query(
                    "text", "What is written so far; it may end in a word.")));
  }

  private Utterance read(Operation.Request request) {
    JsonNode body = request.body();
    return checked(
        new Utterance(
            body.path("person").asText(),
            body.path("room").asText(),
            body.path("text").asText(),
            request.visit().person(),
            spoken(body.path("language").asText(""))));
  }

  private Optional<String> spoken(String tag) {
    if (!tag.isEmpty() && !Language.isUnderstood(home.get(), tag)) {
      throw RefusalException.badInput(
          "Nobody here understands the language %s; say it in one that is shipped, such as de."
              .formatted(tag));
    }
    return Optional.of(tag).filter(one -> !one.isEmpty());
  }

  private JsonNode next(Operation.Request request) {
    Utterance begun =
        checked(
            new Utterance(
                request.parameter("person"),
                request.parameter("room"),
                request.parameter("text"),
                request.visit().person()));
    return JsonMembers.empty()
        .words("words", dialogues.with(begun.person()).next(begun, MOST_NEXT))
        .node();
  }

  private Utterance checked(Utterance utterance) {
    new UtteranceCheck(home.get())
        .objection(utterance)
        .ifPresent(
            sentence -> {
              throw RefusalException.badInput(sentence);
            });
    return utterance;
  }

  /** What was said whole stands in the conversation, and so does the answer. */
  private CompletableFuture<JsonNode> hear(Utterance utterance, boolean more) {
    if (more) {
      return hearing.hear(utterance, true);
    }
    add(ChatEntry.said(utterance, wall.instant()));
    return hearing
        .hear(utterance, false)
        .whenComplete(
            (heard, failure) -> {
              if (failure == null) {
                HeardAnswer.of(heard, readership.ofAll()).forEach(event -> tell(utterance, event));
              }
            });
  }

  /** Hands it over; returned is the number under which it is kept. */
  private JsonNode say(Utterance utterance) {
    long number = add(ChatEntry.said(utterance, wall.instant()));
    Optional<Speech> question = dialogues.asked().answeredBy(utterance);
    question.ifPresentOrElse(speech -> answer(speech, utterance), () -> understand(utterance));
    return JsonNodeFactory.instance.objectNode().put("number", number);
  }

  private void answer(Speech question, Utterance utterance) {
    answering
        .answer(
            question.part(),
            dialogues.answer(utterance, question),
            utterance.asker(),
            Optional.of(utterance.person()))
        .thenAccept(done -> answered(question, utterance))
        .exceptionally(
            failure -> {
              refused(question, utterance, failure);
              return null;
            });
  }

  private void answered(Speech question, Utterance utterance) {
    dialogues.asked().over(question);
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
      dialogues.asked().over(question);
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
    add(ChatEntry.spoken(speech, person(speech.to()), room(speech.to()), wall.instant()));
  }

  /** A question of a script is answered, by whatever way, and open no more. */
  public void hear(GivenAnswer answer) {
    add(ChatEntry.answered(answer, person(answer.to()), room(answer.to()), wall.instant()));
  }

  /** Who is spoken to, where that is one; "": all who are somewhere. */
  private String person(String to) {
    return new UtteranceCheck(home.get()).persons().contains(to) ? to : "";
  }

  private String room(String to) {
    return person(to).isEmpty() ? to : "";
  }

  /** An agent shows a mood, to all who look. */
  public void see(String agent, Mood mood) {
    add(ChatEntry.shown(agent, mood, wall.instant()));
  }

  private synchronized Interlocutor partner(String person) {
    return partnerByPerson.computeIfAbsent(person, partners);
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
      ChoiceMembers.add(row, entry.wanted());
    }
    return document.node();
  }
}
