package org.maestro.console.questions;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;

/**
 * Questions and orders to one platform. Answers are documents as the schemas of the commands
 * describe them; a refusal completes them with a {@link RefusalException}. Any thread may ask, and
 * nothing blocks.
 */
public interface Questions {

  CompletableFuture<JsonNode> goals();

  CompletableFuture<JsonNode> agents();

  CompletableFuture<JsonNode> containers();

  /**
   * What the running agents are for, and which refers to which. The console alone reads all that
   * this follows from.
   */
  CompletableFuture<JsonNode> references();

  CompletableFuture<JsonNode> words();

  /**
   * What is known of it, how surely, and how old that is.
   *
   * @param question in MAESTRO-SL, perhaps with variables
   */
  CompletableFuture<JsonNode> know(String question);

  /**
   * A goal's story.
   *
   * @param step with it: why its member does that step, and not another
   * @param plan of which plan the step is; without: of the latest
   */
  CompletableFuture<JsonNode> story(String goal, OptionalInt plan, OptionalInt step);

  /**
   * What was said for a goal in its story, between agents and on the bus. The console alone has
   * seen that.
   */
  CompletableFuture<JsonNode> trace(String goal);

  /** Gives a goal up. */
  CompletableFuture<Void> cancel(String goal);

  /**
   * Answers a question of a script; one that is not what it asks for is refused, and the question
   * stays open.
   *
   * @param question the part that asks, such as G7.2
   * @param text as people write it
   * @param person of the home whose answer it is; empty: nobody says
   */
  CompletableFuture<Void> answer(String question, String text, Optional<String> person);

  /** The same where nobody says whose answer it is. */
  default CompletableFuture<Void> answer(String question, String text) {
    return answer(question, text, Optional.empty());
  }

  /**
   * The answers that scripts were given, with who was asked what.
   *
   * @param script of that name; empty: of all
   */
  CompletableFuture<JsonNode> answers(Optional<String> script);

  /**
   * A person's day: where she was, what devices were at, and what was asked for.
   *
   * @param date by the home's clocks, such as 2026-01-31; empty: the day that it is
   */
  CompletableFuture<JsonNode> day(String person, Optional<String> date);

  /**
   * Says something as a person of the home.
   *
   * @param language its tag; empty: that which is usual for her
   * @return the number under which it is kept
   */
  CompletableFuture<JsonNode> say(
      String person, String room, String text, Optional<String> language);

  /**
   * Tells words of a person as they are heard.
   *
   * @param text all of the sentence so far
   * @param more whether other words are to come
   * @return what is looked at and begun meanwhile, and what comes of the whole
   */
  CompletableFuture<JsonNode> hear(String person, String room, String text, boolean more);

  /**
   * What was said lately, and what became of it.
   *
   * @param after a number; only what has a higher one
   */
  CompletableFuture<JsonNode> said(long after);

  /** Words with which what a person writes could go on. */
  CompletableFuture<JsonNode> nextWords(String person, String room, String text);

  /**
   * Changes which agents there are.
   *
   * @return what was done, in sentences
   */
  CompletableFuture<JsonNode> order(AgentOrder order);

  /**
   * Brings devices into a safe state.
   *
   * @param member which; empty: all
   */
  CompletableFuture<Void> stop(Optional<String> member);

  /** Starts the central coordination agent again after it was ended. */
  CompletableFuture<Void> revive();
}
