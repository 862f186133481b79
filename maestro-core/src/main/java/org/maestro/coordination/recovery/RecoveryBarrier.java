package org.maestro.coordination.recovery;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * The time after a restart until the members are there again that were there before: what was begun
 * can only be asked for then, and who plans before then finds that nobody can do anything. Over
 * from the start when nobody is awaited. The coordinator's thread only.
 */
public final class RecoveryBarrier {
  private final Set<String> awaited = new TreeSet<>();
  private final List<Runnable> postponed = new ArrayList<>();

  public void await(String member) {
    awaited.add(member);
  }

  /** It is there, and may be on its way elsewhere: as long as something waits, it waits on. */
  public void doubt(String member) {
    if (!postponed.isEmpty()) {
      awaited.add(member);
    }
  }

  /** At once when nobody is awaited; otherwise later, in the order of these calls. */
  public void afterwards(Runnable action) {
    postponed.add(action);
    goOn();
  }

  public void present(String member) {
    awaited.remove(member);
    goOn();
  }

  /** They have been waited for long enough. */
  public void giveUp() {
    awaited.clear();
    goOn();
  }

  private void goOn() {
    while (awaited.isEmpty() && !postponed.isEmpty()) {
      postponed.remove(0).run();
    }
  }
}
