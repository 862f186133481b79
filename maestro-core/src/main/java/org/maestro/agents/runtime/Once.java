package org.maestro.agents.runtime;

import java.util.LinkedHashSet;
import java.util.Set;

/** Tells what comes for the first time from what is repeated; forgets what is long ago. */
public final class Once {
  private static final int REMEMBERED = 1_000;

  private final Set<String> come = new LinkedHashSet<>();

  public boolean isNew(String sentence) {
    boolean isNew = come.add(sentence);
    if (come.size() > REMEMBERED) {
      come.remove(come.iterator().next());
    }
    return isNew;
  }
}
