% SPDX-FileCopyrightText: 2026 The PEMesh developers
% SPDX-License-Identifier: GPL-3.0-or-later
%
% A solver to copy from, for GNU Octave: -Laplace u = 1 with u = (1 - x^2 - y^2) / 4 on the
% boundary, with the lowest-order virtual element method (Beirao da Veiga et al., "The
% Hitchhiker's Guide to the Virtual Element Method", 2014) on the polygons of an OFF file. A MATLAB
% code is wrapped the same way: main() reads the arguments, calls it, and writes the files.
%
%     octave-cli octave-vem.m MESH OUTPUT-FOLDER STEM
1;

function [points, polygons] = read_off (path)
  file = fopen (path);
  fgetl (file); % OFF
  counts = fscanf (file, "%d", 3);
  points = fscanf (file, "%f", [3, counts(1)])'(:, 1:2);
  polygons = cell (counts(2), 1);
  for i = 1:counts(2)
    sides = fscanf (file, "%d", 1);
    polygons{i} = fscanf (file, "%d", sides) + 1;
  end
  fclose (file);
end

function u = exact (points)
  u = (1 - sum (points .^ 2, 2)) / 4;
end

% Stiffness matrix and area of a polygon: projection on linear functions, dofi-dofi.
function [local, area] = element (corners)
  n = rows (corners);
  next = circshift (corners, -1);
  before = circshift (corners, 1);
  cross = corners(:, 1) .* next(:, 2) - next(:, 1) .* corners(:, 2);
  area = sum (cross) / 2;
  centroid = sum ((corners + next) .* cross) / (6 * area);
  h = sqrt (max (max ((corners(:, 1) - corners(:, 1)') .^ 2 + (corners(:, 2) - corners(:, 2)') .^ 2)));
  D = [ones(n, 1), (corners - centroid) / h];
  B = [ones(1, n) / n; (next(:, 2) - before(:, 2))' / (2 * h); (before(:, 1) - next(:, 1))' / (2 * h)];
  projection = (B * D) \ B;
  G = B * D;
  G(1, :) = 0;
  rest = eye (n) - D * projection;
  local = projection' * G * projection + rest' * rest;
end

function fixed = boundary (points, polygons)
  n = rows (points);
  edges = sparse (n, n);
  for i = 1:numel (polygons)
    a = polygons{i};
    edges += sparse (a, circshift (a, -1), 1, n, n);
  end
  [a, b] = find (edges - edges'); % an inner edge is passed in both directions
  fixed = false (n, 1);
  fixed([a; b]) = true;
end

function write (path, numbers)
  file = fopen (path, "w");
  fprintf (file, "%.17g\n", numbers);
  fclose (file);
end

function main (mesh, output, stem)
  [points, polygons] = read_off (mesh);
  n = rows (points);
  I = J = V = cell (numel (polygons), 1);
  load = zeros (n, 1);
  for i = 1:numel (polygons)
    a = polygons{i};
    [local, area] = element (points(a, :));
    [c, r] = meshgrid (a, a);
    I{i} = r(:);
    J{i} = c(:);
    V{i} = local(:);
    load(a) += area / numel (a);
  end
  K = sparse (vertcat (I{:}), vertcat (J{:}), vertcat (V{:}), n, n);
  fixed = boundary (points, polygons);
  truth = exact (points);
  u = truth .* fixed;
  free = ! fixed;
  u(free) = K(free, free) \ (load - K * u)(free);
  name = fullfile (output, stem);
  write ([name, "-solution.txt"], u);
  write ([name, "-ground-truth.txt"], truth);
  write ([name, "-error-inf.txt"], max (abs (u - truth)));
  write ([name, "-condition-number.txt"], max (1, condest (K(free, free))));
end

arguments = argv ();
main (arguments{end - 2:end});
