package org.maestro.console.questions;

import java.util.ArrayList;
import java.util.List;
import org.maestro.agents.content.Words;
import org.maestro.sl.Content.Argument;

/** The words in which the coordinator is told what to do with agents. */
final class OrderWords {
  private OrderWords() {}

  static List<Argument> arguments(AgentOrder order) {
    List<Argument> words = new ArrayList<>();
    if (order instanceof AgentOrder.Add add) {
      words.add(action("add"));
      described(words, add.description(), add.file());
      add.as().ifPresent(name -> words.add(text("as", name)));
      add.container().ifPresent(name -> words.add(text("container", name)));
      if (!add.needs().isEmpty()) {
        words.add(Words.named("needs", add.needs().stream().map(Words::text).toList()));
      }
    } else if (order instanceof AgentOrder.Move move) {
      words.add(action("move"));
      words.add(text("agent", move.agent()));
      words.add(text("to", move.to()));
    } else if (order instanceof AgentOrder.Reconfigure reconfigure) {
      words.add(action("reconfigure"));
      described(words, reconfigure.description(), reconfigure.file());
      words.add(text("agent", reconfigure.agent()));
    } else if (order instanceof AgentOrder.Remove remove) {
      words.add(action("remove"));
      words.add(text("agent", remove.agent()));
    }
    return words;
  }

  private static Argument action(String name) {
    return Words.named("action", Words.name(name));
  }

  private static Argument text(String name, String text) {
    return Words.named(name, Words.text(text));
  }

  private static void described(List<Argument> words, String description, String file) {
    words.add(text("description", description));
    words.add(text("file", file));
  }
}
