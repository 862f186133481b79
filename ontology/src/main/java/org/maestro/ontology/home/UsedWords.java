package org.maestro.ontology.home;

import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Body;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;

/**
 * The predicates and fluents that a goal speaks of, and those that the scripts read or state which
 * it asks for, with all that these run.
 */
final class UsedWords {
  private final Map<String, Script> scripts;
  private final Set<String> words = new TreeSet<>();
  private final Set<String> seen = new HashSet<>();

  UsedWords(Map<String, Script> scripts) {
    this.scripts = scripts;
  }

  Set<String> all() {
    return words;
  }

  UsedWords add(Formula formula) {
    Leaves.of(
        formula,
        atom -> {
          words.add(atom.predicate());
          addScript(atom.predicate());
        },
        fluent -> words.add(fluent.name()));
    return this;
  }

  UsedWords add(Expression expression) {
    Leaves.of(expression, fluent -> words.add(fluent.name()));
    return this;
  }

  private void addScript(String name) {
    Optional.ofNullable(scripts.get(name))
        .filter(script -> seen.add(name))
        .ifPresent(
            script -> {
              script.benefit().ifPresent(this::add);
              add(script.body());
            });
  }

  private void add(Body body) {
    if (body instanceof Body.If choice) {
      add(choice.condition());
    } else if (body instanceof Body.While loop) {
      add(loop.condition());
    } else if (body instanceof Body.ForEach each) {
      add(each.condition());
    } else if (body instanceof Body.Let let) {
      add(let.source());
    } else if (body instanceof Body.Achieve achieve) {
      add(achieve.goal());
    } else if (body instanceof Body.Await await) {
      add(await.condition());
    } else if (body instanceof Body.Pause pause) {
      add(pause.seconds());
    } else if (body instanceof Body.Assert stated) {
      add(stated.effect());
    } else if (body instanceof Body.Run run) {
      addScript(run.script());
    }
    body.parts().forEach(this::add);
  }

  private void add(Body.Source source) {
    if (source instanceof Body.Source.Value value) {
      add(value.number());
    } else if (source instanceof Body.Source.One one) {
      add(one.condition());
    } else {
      addScript(((Body.Run) source).script());
    }
  }

  private void add(Effect effect) {
    if (effect instanceof Effect.Add added) {
      add(added.atom());
    } else if (effect instanceof Effect.Delete deleted) {
      add(deleted.atom());
    } else if (effect instanceof Effect.All all) {
      all.effects().forEach(this::add);
    } else if (effect instanceof Effect.When when) {
      add(when.condition());
      add(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      add(forall.effect());
    } else if (effect instanceof Effect.Change change) {
      add(change.fluent());
      add(change.value());
    }
  }
}
