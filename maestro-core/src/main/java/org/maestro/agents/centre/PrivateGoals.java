package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.maestro.agents.content.Words;
import org.maestro.agents.knowledge.Readers;
import org.maestro.agents.runtime.Caller;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.PrivateWords;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * Goals in private words, and scripts that use such: what is told of them is told to those who may
 * read these words, as facts are (ADE, 4.1; A57). Agent thread only.
 */
final class PrivateGoals {
  private static final String KEPT_BACK = "private";

  private final KnowledgeBase knowledge;
  private final Readers readers;
  private final Supplier<String> platform;

  /**
   * @param platform whose agents are called by their names alone
   */
  PrivateGoals(KnowledgeBase knowledge, Supplier<String> platform) {
    this.knowledge = knowledge;
    this.readers = new Readers(knowledge::home);
    this.platform = platform;
  }

  /** What who asks may read. */
  ReadingRights rights(ACLMessage message, Words words) {
    return readers.of(Caller.of(message, platform.get()).askingFor(words.string("for")));
  }

  /** Why who asks may not state the goal: that it is reached or not tells what is private. */
  Optional<String> objection(ACLMessage message, Words words, Formula goal) {
    return rights(message, words).objection(goal);
  }

  /** A line of the list of goals as it is told to who has these rights. */
  Content line(Content status, ReadingRights rights) {
    Optional<Formula> goal =
        rights.areWhole() ? Optional.empty() : formula(Words.of(status).strings("goal"));
    Set<String> used =
        goal.map(formula -> PrivateWords.of(knowledge.home()).usedFor(formula)).orElse(Set.of());
    if (rights.objection(used).isEmpty()) {
      return status;
    }
    boolean isInPrivateWords = rights.objection(goal.orElseThrow()).isPresent();
    List<Content.Argument> arguments = new ArrayList<>();
    for (Content.Argument argument : status.arguments()) {
      if (argument instanceof Content.Argument.Named named) {
        switch (named.name()) {
          case "goal" ->
              arguments.add(
                  isInPrivateWords
                      ? Words.named("goal", named.arguments().get(0), Words.text(KEPT_BACK))
                      : argument);
          case "detail" -> arguments.add(Words.named("detail", Words.text("")));
          case "worth", "stakes" -> {
            // Its numbers come from what is private.
          }
          default -> arguments.add(argument);
        }
      }
    }
    return new Content(status.operator(), arguments);
  }

  private Optional<Formula> formula(List<String> goal) {
    try {
      return goal.size() < 2
          ? Optional.empty()
          : Optional.of(SlParser.formula(goal.get(1), knowledge.home().vocabulary()::isFluent));
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }
}
