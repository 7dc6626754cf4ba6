#!/usr/bin/env python3
"""Surfaces as connected components between depth steps and changes of the surface's direction.

A program for Facet's method of kind `external`; needs numpy and OpenCV. In an experiment:

  methods: [{name: components, kind: external, params: {
    command: "python3 ../tools/examples/components.py {depth} {intrinsics} {out}"}}]
"""
import json
import sys

import cv2
import numpy as np

depth_file, intrinsics_file, out = sys.argv[1:]
camera = json.load(open(intrinsics_file))
depth = cv2.imread(depth_file, cv2.IMREAD_UNCHANGED).astype(np.float32) * camera["depth_unit_m"]
known = depth > 0

smooth = cv2.GaussianBlur(depth, (7, 7), 0)
y, x = np.mgrid[: depth.shape[0], : depth.shape[1]].astype(np.float32)
points = np.dstack(((x - camera["cx"]) / camera["fx"] * smooth, (y - camera["cy"]) / camera["fy"] * smooth, smooth))
normals = np.cross(np.gradient(points, axis=1), np.gradient(points, axis=0))
normals /= np.linalg.norm(normals, axis=2, keepdims=True) + 1e-12

step = cv2.morphologyEx(depth, cv2.MORPH_GRADIENT, np.ones((3, 3))) > 0.02 * depth
turn = sum(np.linalg.norm(np.gradient(cv2.blur(normals, (5, 5)), axis=a), axis=2) for a in (0, 1)) > 0.12
_, labels, stats, _ = cv2.connectedComponentsWithStats((known & ~step & ~turn).astype(np.uint8), connectivity=4)
labels[stats[labels, cv2.CC_STAT_AREA] < 150] = 0

grown = cv2.dilate(labels.astype(np.uint16), np.ones((5, 5)))  # gives back the pixels of the edges
cv2.imwrite(out + ".labels.png", np.where((labels == 0) & known, grown, labels).astype(np.uint16))
