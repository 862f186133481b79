package org.maestro.agents.references;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.Words;
import org.maestro.sl.Content;

/**
 * The agent that somebody wants to refer to: by its name, or as one that offers a feature now.
 *
 * @param agent its local name
 * @param feature by its type in the yellow pages
 */
public record Wanted(Optional<String> agent, Optional<String> feature) {

  public static Wanted agent(String name) {
    return new Wanted(Optional.of(name), Optional.empty());
  }

  /** Whoever offers it. */
  public static Wanted feature(String type) {
    return new Wanted(Optional.empty(), Optional.of(type));
  }

  /** Reads what {@link #inWords} has written. */
  public static Wanted read(Words words) {
    return new Wanted(words.string("agent"), words.string("feature"));
  }

  /** Such as {@code (refer (:agent lamp-1))}. */
  public Content inWords() {
    List<Content.Argument> arguments = new ArrayList<>();
    agent.ifPresent(name -> arguments.add(Words.named("agent", Words.name(name))));
    feature.ifPresent(type -> arguments.add(Words.named("feature", Words.name(type))));
    return new Content("refer", arguments);
  }
}
