package org.maestro.ontology.permission;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Body;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * Holds a script against what a person may have done: those of its steps that are done in any case.
 * What it does on a condition only is found out when it comes to it.
 */
final class ScriptObjections {
  private final Home home;
  private final Parts parts;

  /** Tells what is to be said against a step. */
  interface Parts {
    Optional<Objection> objection(Formula goal);

    Optional<Objection> objection(Way call);

    Optional<Objection> objection(Script script, List<Term> arguments);
  }

  ScriptObjections(Home home, Parts parts) {
    this.home = home;
    this.parts = parts;
  }

  /**
   * @param arguments variables for what is not known yet
   */
  Optional<Objection> of(Script script, List<Term> arguments) {
    Map<String, Term> values = new HashMap<>();
    IntStream.range(0, Math.min(arguments.size(), script.parameters().size()))
        .forEach(i -> values.put(script.parameters().get(i).name(), arguments.get(i)));
    return of(script.body(), new Substitution(values));
  }

  private Optional<Objection> of(Body body, Substitution known) {
    if (body instanceof Body.Achieve achieve) {
      return parts.objection(known.apply(achieve.goal()));
    } else if (body instanceof Body.Do call) {
      return ofCall(call, known);
    } else if (body instanceof Body.Run run) {
      return Optional.ofNullable(home.scripts().get(run.script()))
          .flatMap(
              script ->
                  parts.objection(script, run.arguments().stream().map(known::apply).toList()));
    }
    boolean isDoneInAnyCase =
        body instanceof Body.Seq
            || body instanceof Body.Par
            || body instanceof Body.Let
            || body instanceof Body.Hold
            || body instanceof Body.Ask;
    return isDoneInAnyCase
        ? body.parts().stream().flatMap(part -> of(part, known).stream()).findFirst()
        : Optional.empty();
  }

  private Optional<Objection> ofCall(Body.Do call, Substitution known) {
    Map<String, Term> values = new HashMap<>();
    call.parameters()
        .forEach(
            (name, term) -> {
              Term value = known.apply(term);
              if (!(value instanceof Term.Variable)) {
                values.put(name, value);
              }
            });
    return device(known.apply(call.member()))
        .flatMap(
            device -> {
              values.put(Self.VARIABLE.name(), new Term.Name(device.id()));
              return device.features().stream()
                  .filter(feature -> feature.name().equals(call.feature()))
                  .findFirst()
                  .map(feature -> new Way(device, feature, values, ""));
            })
        .flatMap(parts::objection);
  }

  private Optional<Device> device(Term member) {
    return member instanceof Term.Name name
        ? Optional.ofNullable(home.devices().get(name.text()))
        : Optional.empty();
  }
}
