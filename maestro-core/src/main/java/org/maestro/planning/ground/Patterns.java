package org.maestro.planning.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Sets of ground atoms, each written as an atom in which -1 stands for any object. */
final class Patterns {
  /** Any object. */
  static final int ANY = -1;

  /** For each symbol and each set of open places the atoms. */
  private final Map<Integer, Map<Integer, Set<List<Integer>>>> bySymbol = new LinkedHashMap<>();

  /** Adds the pattern unless it is part of one that is there; tells whether it was added. */
  boolean add(Atom pattern) {
    if (matches(pattern)) {
      return false;
    }
    bySymbol
        .computeIfAbsent(pattern.symbol(), absent -> new LinkedHashMap<>())
        .computeIfAbsent(mask(pattern.terms()), absent -> new HashSet<>())
        .add(key(mask(pattern.terms()), pattern.terms()));
    return true;
  }

  /** Whether all atoms of the pattern, or the ground atom, are in one of these. */
  boolean matches(Atom pattern) {
    return matches(pattern.symbol(), pattern.terms());
  }

  boolean matches(int symbol, int[] terms) {
    Map<Integer, Set<List<Integer>>> byMask = bySymbol.get(symbol);
    if (byMask == null) {
      return false;
    }
    int mask = mask(terms);
    for (Map.Entry<Integer, Set<List<Integer>>> entry : byMask.entrySet()) {
      int fixed = entry.getKey();
      if ((fixed & ~mask) == 0 && (fixed == 0 || entry.getValue().contains(key(fixed, terms)))) {
        return true;
      }
    }
    return false;
  }

  boolean hasSymbol(int symbol) {
    return bySymbol.containsKey(symbol);
  }

  private static int mask(int[] terms) {
    int mask = 0;
    for (int i = 0; i < terms.length; i++) {
      if (terms[i] != ANY) {
        mask |= 1 << i;
      }
    }
    return mask;
  }

  private static List<Integer> key(int mask, int[] terms) {
    if (Integer.bitCount(mask) == terms.length) {
      return Arrays.stream(terms).boxed().toList();
    }
    List<Integer> key = new ArrayList<>();
    for (int i = 0; i < terms.length; i++) {
      if ((mask >> i & 1) != 0) {
        key.add(terms[i]);
      }
    }
    return key;
  }
}
