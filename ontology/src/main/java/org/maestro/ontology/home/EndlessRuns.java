package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.sl.Body;

/**
 * Finds scripts that run themselves, straight or through others, before any of them can end. Only
 * what is run in any case counts: neither what stands under a condition, in a loop or in a
 * recovery, nor what comes after a step in which the script may be over.
 */
final class EndlessRuns {
  private final Set<String> found = new LinkedHashSet<>();

  private EndlessRuns() {}

  /** The names of scripts from the given one back to itself; none when it can end. */
  static List<String> from(String name, Map<String, Script> scripts) {
    return path(name, name, scripts, new LinkedHashSet<>());
  }

  private static List<String> path(
      String at, String to, Map<String, Script> scripts, Set<String> seen) {
    Script script = scripts.get(at);
    if (script == null) {
      return List.of();
    }
    for (String next : runBy(script)) {
      List<String> rest = List.of();
      if (next.equals(to)) {
        rest = List.of(to);
      } else if (seen.add(next)) {
        rest = path(next, to, scripts, seen);
      }
      if (!rest.isEmpty()) {
        List<String> path = new ArrayList<>(List.of(at));
        path.addAll(rest);
        return path;
      }
    }
    return List.of();
  }

  private static Set<String> runBy(Script script) {
    EndlessRuns runs = new EndlessRuns();
    runs.visit(script.body());
    return runs.found;
  }

  /** Answers whether what follows is reached in any case. */
  private boolean visit(Body body) {
    if (body instanceof Body.Run run) {
      found.add(run.script());
      return true;
    } else if (body instanceof Body.Seq seq) {
      return seq.parts().stream().allMatch(this::visit);
    } else if (body instanceof Body.Hold || body instanceof Body.Ask) {
      return body.parts().stream().allMatch(this::visit);
    } else if (body instanceof Body.Let let) {
      if (let.source() instanceof Body.Run run) {
        found.add(run.script());
      }
      return let.parts().stream().allMatch(this::visit);
    } else if (body instanceof Body.Par par) {
      par.parts().forEach(this::visit);
    } else if (body instanceof Body.Try attempt) {
      visit(attempt.body());
      attempt.last().ifPresent(this::visit);
    }
    return !mayEnd(body);
  }

  private static boolean mayEnd(Body body) {
    return body instanceof Body.Return
        || body instanceof Body.Fail
        || body.parts().stream().anyMatch(EndlessRuns::mayEnd);
  }
}
